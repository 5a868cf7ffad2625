/// summary.json and events.csv: metrics and events of a run.
#pragma once

#include <filesystem>

#include "tools/outputs/records/run_history.hpp"
#include "tools/run/metrics/people_metrics.hpp"

namespace castaway::testbed {

/// summary.json: docs/formats.md describes the format, metrics/localizer_metrics.hpp the metrics.
///
/// events.csv: stamp_s, kind, detail, localizer, from_x_m, from_y_m, from_yaw_rad, to_x_m, to_y_m,
/// to_yaw_rad, time_s, distance_m, sorted by time. Kinds: events of the robot ("kidnap",
/// "collision"...; from and to are true poses), "alarm on" and "alarm off" of a localizer, and its
/// "recovery", with time and distance since the kidnap or the start.
class SummarySink final : public RunSink {
 public:
  SummarySink(std::filesystem::path run_folder, RunInfo info,
              std::size_t most_rows = RunHistory::kMostRows)
      : run_folder_(std::move(run_folder)), history_(std::move(info), most_rows) {}

  void on_event(const RunEvent& event) override { history_.add(event); }
  void on_odometry(const OdometryFrame& frame) override { history_.add(frame); }
  void on_scan(const ScanRecord& record) override {
    history_.add(record);
    people_.add(record.people);
  }
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  std::filesystem::path run_folder_;
  RunHistory history_;
  PeopleMeter people_;
};

}  // namespace castaway::testbed
