/// Outcomes of kidnap trials, and the summary of a batch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/batch/trials/wrong_scans.hpp"
#include "tools/run/metrics/calibration.hpp"
#include "tools/run/metrics/run_rows.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {

/// Outcome of one localizer in one trial. Times are from the kidnap to the answer
/// (`MetricRow::answered`).
struct KidnapOutcome {
  std::optional<double> recovered_s;   ///< [s] First answer from which on it is right until the end
                                       ///< of the trial.
  std::optional<double> confident_s;   ///< [s] First answer that is right and without the alarm.
  std::optional<double> alarm_s;       ///< [s] First alarm.
  std::optional<double> noticed_s;     ///< [s] First answer that is right or raises the alarm.
  std::vector<PoseError> tracking;     ///< Errors of the scans before the kidnap and after the
                                       ///< recovery.
  WrongScans since_kidnap{};           ///< The scans after the kidnap.
  WrongScans since_distinguishable{};  ///< Those since `KidnapReport::distinguishable`; none if the
                                       ///< places never are.
  Calibration calibration{};           ///< Over the scans after the kidnap.
};

/// Evaluates the rows of one localizer in a trial that has a known start and one kidnap and ends at
/// `end`. An output is right if its error is below 0.5 m and 0.35 rad. `distinguishable`: as in the
/// trial's report.
KidnapOutcome kidnap_outcome(const std::vector<MetricRow>& rows,
                             const std::vector<RunEvent>& events, Stamp end,
                             const std::optional<Stamp>& distinguishable = {});

/// Result of the global search for the first whole scan after the kidnap.
struct SearchOutcome {
  std::optional<std::size_t> rank;  ///< Rank of the right pose, 0 for the best; nothing if it is
                                    ///< not listed.
  double blocked_share = 0.0;       ///< In [0, 1]: share of the beams blocked by people.
  double right = 0.0;               ///< Log-likelihood of the right place, whether listed or not.
  double fifth = 0.0;               ///< Log-likelihood of the fifth place listed, or of the last.
};

struct KidnapReport {
  int index = 0;
  int obstacles = 0;
  SE2 T_map_from;  ///< True pose of base before the kidnap.
  SE2 T_map_to;    ///< True pose of base after the kidnap.
  SearchOutcome search;
  std::vector<KidnapOutcome> outcomes;  ///< By localizer.
  std::optional<VoidRun> void_run{};    ///< The robot got nowhere, so the trial does not count.
  /// First scan at which the place was distinguishable from that without the kidnap
  /// (`Distinguishability`).
  std::optional<Stamp> distinguishable{};
};

/// Results of one localizer over several trials.
struct KidnapRow {
  std::string localizer;
  int recovered = 0;                  ///< Number of recoveries within the requested time.
  std::vector<double> recovered_s;    ///< [s] All recoveries, ascending.
  std::vector<double> confident_s;    ///< [s] Ascending.
  std::vector<double> alarm_s;        ///< [s] Ascending.
  std::vector<double> noticed_s;      ///< [s] Ascending.
  std::optional<PoseError> tracking;  ///< Mean over all trials' scans.
  WrongScans since_kidnap;            ///< The scans after the kidnaps.
  WrongScans since_distinguishable;   ///< Those since the places were distinguishable.
  Calibration calibration;            ///< Over the scans after the kidnaps.
};

/// Summary of the trials with one number of obstacles.
struct KidnapBatch {
  int obstacles = 0;
  int kidnaps = 0;             ///< Trials that count.
  int voids = 0;               ///< Void trials, which do not count.
  int top1 = 0;                ///< Trials in which the right pose is the best place found.
  int top5 = 0;                ///< Trials in which the right pose is among the best five.
  int distinguishable = 0;     ///< Trials whose places become distinguishable.
  double blocked_share = 0.0;  ///< Mean over the trials.
  std::vector<KidnapRow> rows;
};

/// Summarises a batch of trials; `within_s` [s]: later recoveries do not count.
KidnapBatch summarise(std::vector<KidnapReport> reports, const std::vector<std::string>& localizers,
                      double within_s);

}  // namespace castaway::testbed
