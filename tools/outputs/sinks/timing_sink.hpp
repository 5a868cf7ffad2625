/// timing.csv and timing.json: all clock readings. They are the only files that differ between
/// repetitions of a run.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/base/formats/csv.hpp"
#include "tools/outputs/records/thinned_sample.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// timing.csv: stamp_s, localizer, stage ("update": the CPU time of a scan and the odometry before
/// it; otherwise one of the localizer's stages), cpu_ms. timing.json: see docs/formats.md. Beside
/// `update_ms` it holds the same statistics of every stage over the scans at which the stage ran
/// (`scans`). `memory_mb.peak` is the peak resident set of the process so far.
class TimingSink final : public RunSink {
 public:
  TimingSink(std::filesystem::path run_folder, RunInfo info);

  void on_event(const RunEvent& event) override { note(event.stamp); }
  void on_odometry(const OdometryFrame& frame) override { note(frame.odometry.stamp); }
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  std::filesystem::path run_folder_;
  void note(Stamp stamp) { first_stamp_ = std::min(first_stamp_, stamp); }

  RunInfo info_;
  Stamp first_stamp_ = Stamp::max();  // Earliest stamp of any delivered data.
  CsvWriter csv_;
  std::vector<ThinnedSample> update_ms_;                        // By localizer.
  std::vector<std::map<std::string, ThinnedSample>> stage_ms_;  // By localizer and stage.
};

}  // namespace castaway::testbed
