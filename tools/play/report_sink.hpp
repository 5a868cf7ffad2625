/// report.html, written when the run is over.
#pragma once

#include <filesystem>
#include <memory>

#include "tools/play/report_writer.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Renders the report from the files of other sinks, so it must come after them.
class ReportSink final : public RunSink {
 public:
  /// `levels`: null in a run on one floor.
  ReportSink(ReportWriter write, std::filesystem::path run_folder, RosMap map,
             std::shared_ptr<const LevelMaps> levels = nullptr);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord&) override {}
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  ReportWriter write_;
  std::filesystem::path run_folder_;
  RosMap map_;
  std::shared_ptr<const LevelMaps> levels_;
};

}  // namespace castaway::testbed
