/// Plays random kidnaps and evaluates localizers on them.
#pragma once

#include <functional>

#include "tools/batch/trials/kidnap_summary.hpp"
#include "tools/batch/trials/kidnap_trials.hpp"

namespace castaway::testbed {

/// Trials of one batch.
struct KidnapTrialCount {
  int kidnaps = 1;
  int obstacles = 0;  ///< People in each.
  int workers = 1;    ///< Trials at a time.
};

/// Plays trials 0 to `kidnaps` - 1; all localizers see the same runs. `on_trial` is called after
/// each trial. The reports are deterministic, and in the order of the trials. Throws
/// std::runtime_error naming the trial that fails.
std::vector<KidnapReport> play_kidnaps(
    const KidnapTrials& trials, const std::vector<LocalizerSpec>& localizers,
    const KidnapTrialCount& count, const std::function<void()>& on_trial = [] {});

}  // namespace castaway::testbed
