/// What sinks remember of a run until it ends.
#pragma once

#include <vector>

#include "tools/metrics/localizer_metrics.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Events and, a localizer, the rows that its metrics are made of.
struct RunHistory {
  RunInfo info;
  std::vector<RunEvent> events;
  /// By localizer, as in `info`; by stamp. Of a run of more than `most_rows` scans every second one
  /// is kept, then every fourth, and so on: memory does not grow with a run's length.
  std::vector<std::vector<MetricRow>> rows;
  std::vector<MetricRow> path;       ///< True poses by stamp, kept where no localizer rides along.
  Stamp first_stamp = Stamp::max();  ///< Of all that was delivered; max: nothing was.

  std::size_t scans = 0;   ///< That were delivered...
  std::size_t stride = 1;  ///< ...of which one in so many is kept.
  std::size_t most_rows;   ///< That are kept of a localizer.

  static constexpr std::size_t kMostRows = 250000;  ///< Seven hours at 10 Hz.

  explicit RunHistory(RunInfo run, std::size_t most = kMostRows)
      : info(std::move(run)), rows(info.localizers.size()), most_rows(most) {}

  void add(const RunEvent& event);
  void add(const OdometryFrame& frame);
  void add(const ScanRecord& record);
  /// Leaves out every second row if there are more than `most`.
  void thin(std::size_t most);

  /// Metrics of localizer `index` of a run that ended at `end`.
  [[nodiscard]] LocalizerMetrics metrics(std::size_t index, Stamp end) const {
    return measure(rows[index], events, info.known_start, end);
  }
};

}  // namespace castaway::testbed
