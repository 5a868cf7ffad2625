/// Evaluates a localizer on a recorded log: tracking, unknown starts and spliced kidnaps at evenly
/// spaced scans.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/batch/evaluate/evaluation_row.hpp"
#include "tools/batch/evaluate/recorded_place.hpp"
#include "tools/batch/evaluate/stress.hpp"
#include "tools/batch/jobs/trial_runner.hpp"
#include "tools/play/replay/spliced_kidnap.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Trials of an evaluation.
struct EvaluationConfig {
  int starts = 24;               ///< Number of unknown starts.
  int kidnaps = 24;              ///< Number of spliced kidnaps.
  double window_s = 60.0;        ///< [s] Length of every start trial, and of the part of a kidnap
                                 ///< trial after the kidnap.
  int scans_before_kidnap = 30;  ///< Scans tracked from a known start before a kidnap.
  SpliceKind kidnap_to = SpliceKind::kFar;  ///< Where the robot was before each kidnap.
  bool tracking = true;                     ///< Also track the whole log from its true start.
  StressConfig stress;
  std::uint64_t seed = 1;
  /// Called at every scan of a trial, in its process; may throw to end the evaluation.
  std::function<void()> on_scan{};
  TrialRunner run = run_at_once(1);  ///< Runs the trials.
};

/// Throws std::invalid_argument if a value is out of range.
void validate(const EvaluationConfig& config);

/// Runs all trials of one localizer on several recordings of a place, in place of its own frames.
/// Returns for each recording the starts, the kidnaps, then tracking, a row each. Trials begin at
/// evenly spaced scans; kidnaps lead to these scans. `on_trial` is called after each trial. The
/// results, except for CPU times, do not depend on the runner. A trial that the runner has no text
/// of adds nothing to its row. Throws as the runner does, std::invalid_argument if a recording has
/// no true poses, the place has no map for the localizer, or the stress changes a map that the
/// localizer does not use.
std::vector<std::vector<EvaluationRow>> evaluate_trials(
    const RecordedPlace& place, const std::vector<const Frames*>& recordings,
    const LocalizerSpec& localizer, const EvaluationConfig& config,
    const std::function<void()>& on_trial = [] {});

/// Throws std::invalid_argument naming the log if no scan of it has a true pose.
void require_truth(const std::string& log, const Frames& frames);

/// The index of the scan at which trial `k` of `count` begins, in a recording of `scans` scans.
std::size_t scan_of_trial(std::size_t scans, int k, int count);

/// The sum over all trials, with ascending times.
EvaluationRow sum_trials(const RecordedPlace& place, const LocalizerSpec& localizer,
                         const std::vector<EvaluationRow>& trials);

/// Runs all trials of one localizer and sums them.
EvaluationRow evaluate(
    const RecordedPlace& place, const LocalizerSpec& localizer, const EvaluationConfig& config,
    const std::function<void()>& on_trial = [] {});

}  // namespace castaway::testbed
