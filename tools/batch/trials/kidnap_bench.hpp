/// Plays random kidnaps and evaluates localizers on them.
#pragma once

#include <functional>
#include <vector>

#include "tools/batch/jobs/trial_runner.hpp"
#include "tools/batch/trials/kidnap_summary.hpp"
#include "tools/batch/trials/kidnap_trials.hpp"

namespace castaway::testbed {

/// Trials of one batch.
struct KidnapTrialCount {
  int kidnaps = 1;
  int obstacles = 0;                 ///< People in each.
  TrialRunner run = run_at_once(1);  ///< Runs them.
};

/// Plays trials 0 to `kidnaps` - 1; all localizers see the same runs. `on_trial` is called after
/// each trial. The reports are deterministic, and in the order of the trials, without those that
/// the runner has no text of. Throws as the runner does.
std::vector<KidnapReport> play_kidnaps(
    const KidnapTrials& trials, const std::vector<LocalizerSpec>& localizers,
    const KidnapTrialCount& count, const std::function<void()>& on_trial = [] {});

}  // namespace castaway::testbed
