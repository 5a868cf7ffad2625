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
  std::vector<std::vector<MetricRow>> rows;  ///< By localizer, as in `info`; by stamp.
  std::vector<MetricRow> path;       ///< True poses by stamp, kept where no localizer rides along.
  Stamp first_stamp = Stamp::max();  ///< Of all that was delivered; max: nothing was.

  explicit RunHistory(RunInfo run) : info(std::move(run)), rows(info.localizers.size()) {}

  void add(const RunEvent& event);
  void add(const OdometryFrame& frame);
  void add(const ScanRecord& record);

  /// Metrics of localizer `index` of a run that ended at `end`.
  [[nodiscard]] LocalizerMetrics metrics(std::size_t index, Stamp end) const {
    return measure(rows[index], events, info.known_start, end);
  }
};

}  // namespace castaway::testbed
