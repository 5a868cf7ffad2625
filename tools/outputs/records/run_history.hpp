/// Data of a run that sinks keep until it ends.
#pragma once

#include <vector>

#include "tools/run/metrics/localizer_metrics.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Events, and for each localizer the rows from which its metrics are computed.
struct RunHistory {
  RunInfo info;
  std::vector<RunEvent> events;
  /// By localizer in the order of `info`, then by stamp. If a run has more than `most_rows` scans,
  /// every second one is kept, then every fourth, and so on, so memory does not grow with the
  /// length of a run.
  std::vector<std::vector<MetricRow>> rows;
  std::vector<MetricRow> path;       ///< True poses by stamp; filled only if the run has no
                                     ///< localizers.
  Stamp first_stamp = Stamp::max();  ///< Earliest stamp of any delivered data; max if there was
                                     ///< none.

  std::size_t scans = 0;   ///< Number of delivered scans.
  std::size_t stride = 1;  ///< One of this many scans is kept.
  std::size_t most_rows;   ///< Maximum number of rows per localizer.

  static constexpr std::size_t kMostRows = 250000;  ///< Seven hours at 10 Hz.

  explicit RunHistory(RunInfo run, std::size_t most = kMostRows)
      : info(std::move(run)), rows(info.localizers.size()), most_rows(most) {}

  void add(const RunEvent& event);
  void add(const OdometryFrame& frame);
  void add(const ScanRecord& record);
  /// Drops every second row if there are more than `most`.
  void thin(std::size_t most);

  /// Metrics of localizer `index` of a run that ended at `end`.
  [[nodiscard]] LocalizerMetrics metrics(std::size_t index, Stamp end) const {
    return measure(rows[index], events_for(info.localizers[index], events), info.known_start, end);
  }
};

}  // namespace castaway::testbed
