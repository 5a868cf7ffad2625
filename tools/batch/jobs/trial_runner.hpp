/// Trials whose results are text: in this process, in several, or kept in a folder.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/base/process/worker_process.hpp"

namespace castaway::testbed {

/// Runs trials 0 to `trials` - 1 by `run_trial`, and tells `on_trial` of each that is done. Returns
/// their texts, in order; empty: there is none, because another process makes the trial or because
/// it failed and the runner keeps failures.
using TrialRunner = std::function<std::vector<std::string>(int trials, const Work& run_trial,
                                                           const std::function<void()>& on_trial)>;

/// Runs trials in this process, or for `workers` > 1 in that many. Ends with the first trial that
/// fails: throws LocalizerFailure if a localizer did, else as the trial does, or std::runtime_error
/// that names it.
TrialRunner run_at_once(int workers);

}  // namespace castaway::testbed
