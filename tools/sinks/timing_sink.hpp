/// timing.csv and timing.json: all that a clock measured. The only files of a run that differ from
/// one repetition to the next.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/formats/csv.hpp"
#include "tools/records/thinned_sample.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// timing.csv: stamp_s, localizer, stage ("update": the whole CPU time of a scan and the odometry
/// before it; otherwise one of the localizer's stages), cpu_ms. timing.json: as docs/formats.md
/// says; beside `update_ms` the same of every stage, over the scans at which it ran (`scans`);
/// `memory_mb.peak`: the largest resident set of the process so far.
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
  Stamp first_stamp_ = Stamp::max();  // Of all that was delivered.
  CsvWriter csv_;
  std::vector<ThinnedSample> update_ms_;                        // By localizer.
  std::vector<std::map<std::string, ThinnedSample>> stage_ms_;  // By localizer and stage.
};

}  // namespace castaway::testbed
