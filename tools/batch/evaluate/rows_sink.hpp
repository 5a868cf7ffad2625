/// Collects the input of the metrics from a run with one localizer.
#pragma once

#include <vector>

#include "tools/outputs/records/run_history.hpp"

namespace castaway::testbed {

/// A run with one localizer, as input of the metrics.
struct RowsOfRun {
  std::vector<MetricRow> rows;
  std::vector<RunEvent> events;
  std::vector<double> update_ms;  ///< [ms] CPU time of each scan.
  Stamp end{};
};

/// Writes into rows that must outlive the sink.
class RowsSink final : public RunSink {
 public:
  explicit RowsSink(RowsOfRun& rows);

  void on_event(const RunEvent& event) override { history_.add(event); }
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming&) override;

 private:
  RowsOfRun& rows_;
  RunHistory history_;
};

}  // namespace castaway::testbed
