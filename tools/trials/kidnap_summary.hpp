/// What kidnaps amount to: one trial's outcome, and a batch of them in one row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/metrics/run_rows.hpp"
#include "tools/metrics/void_run.hpp"

namespace castaway::testbed {

/// One localizer in one trial. Times are from the kidnap to the answer (`MetricRow::answered`).
struct KidnapOutcome {
  std::optional<double> recovered_s;  ///< [s] From then on it is right to the end of the trial.
  std::optional<double> confident_s;  ///< [s] First right while it does not call itself lost.
  std::optional<double> alarm_s;      ///< [s] First calls itself lost.
  std::optional<double> noticed_s;    ///< [s] First calls itself lost or is right.
  std::vector<PoseError> tracking;    ///< Of the scans before the kidnap and after the recovery.
  int scans = 0;                      ///< After the kidnap, with truth.
  int wrong = 0;                      ///< Of those: wrong while it does not call itself lost.
};

/// Judges the rows of one localizer in a trial from a known start with one kidnap, which ended at
/// `end`. Right is an error below 0.5 m and 0.35 rad.
KidnapOutcome kidnap_outcome(const std::vector<MetricRow>& rows,
                             const std::vector<RunEvent>& events, Stamp end);

/// What the search of the whole map makes of the first whole scan after the kidnap.
struct SearchOutcome {
  std::optional<std::size_t> rank;  ///< Of the right pose, 0 the best; nothing: it is not listed.
  double blocked_share = 0.0;       ///< In [0, 1]: of the beams, by people.
  double right = 0.0;               ///< Log-likelihood of the right place, listed or not...
  double fifth = 0.0;               ///< ...and of the fifth place listed, or of the last.
};

/// One trial.
struct KidnapReport {
  int index = 0;
  int obstacles = 0;
  SE2 T_map_from;  ///< True pose of base before the kidnap...
  SE2 T_map_to;    ///< ...and after it.
  SearchOutcome search;
  std::vector<KidnapOutcome> outcomes;  ///< By localizer.
  std::optional<VoidRun> void_run{};    ///< The robot got nowhere: the trial does not count.
};

/// Counts of one localizer over trials.
struct KidnapRow {
  std::string localizer;
  int recovered = 0;                  ///< Within the time asked for.
  std::vector<double> recovered_s;    ///< [s] All recoveries, ascending.
  std::vector<double> confident_s;    ///< [s] Ascending.
  std::vector<double> alarm_s;        ///< [s] Ascending.
  std::vector<double> noticed_s;      ///< [s] Ascending.
  std::optional<PoseError> tracking;  ///< Mean over all trials' scans.
  double wrong_share = 0.0;           ///< In [0, 1]: of the scans after the kidnaps.
};

/// Trials with one number of obstacles, put together.
struct KidnapBatch {
  int obstacles = 0;
  int kidnaps = 0;             ///< That count.
  int voids = 0;               ///< Trials that do not.
  int top1 = 0;                ///< Right pose is the best place found...
  int top5 = 0;                ///< ...or among the best five.
  double blocked_share = 0.0;  ///< Mean over the trials.
  std::vector<KidnapRow> rows;
};

/// Puts the trials of a batch together; `within_s` [s]: recoveries that count.
KidnapBatch summarise(std::vector<KidnapReport> reports, const std::vector<std::string>& localizers,
                      double within_s);

}  // namespace castaway::testbed
