/// Plays random kidnaps and evaluates localizers on them.
#pragma once

#include <functional>

#include "tools/trials/kidnap_summary.hpp"
#include "tools/trials/kidnap_trials.hpp"

namespace castaway::testbed {

/// Plays trials 0 to `kidnaps` - 1 with `obstacles` people; all localizers see the same runs.
/// `on_trial` is called after each trial. The reports are deterministic.
std::vector<KidnapReport> play_kidnaps(
    const KidnapTrials& trials, const std::vector<LocalizerSpec>& localizers, int kidnaps,
    int obstacles, const std::function<void(const KidnapReport&)>& on_trial = [](const auto&) {});

}  // namespace castaway::testbed
