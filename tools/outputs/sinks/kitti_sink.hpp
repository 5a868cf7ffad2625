/// kitti/: true poses in the format of the KITTI odometry benchmark.
#pragma once

#include <filesystem>
#include <string>

#include "tools/base/files/file.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// A pose of base in map as the 12 numbers of its 3 x 4 matrix, row by row, and a newline. Axes
/// follow REP-103 (x forward, y left, z up), not KITTI's camera frame (z forward, x right, y down).
std::string kitti_line(const SE2& T_map_base);
std::string kitti_line(const Eigen::Isometry3d& T_map_base);

/// poses.txt: a row for each scan whose true pose is known, in runs on several floors with height,
/// roll and pitch. times.txt: the stamps [s] of the same scans.
class KittiSink final : public RunSink {
 public:
  explicit KittiSink(const std::filesystem::path& run_folder)
      : poses_(run_folder / "kitti" / "poses.txt"), times_(run_folder / "kitti" / "times.txt") {}

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  AtomicFile poses_;
  AtomicFile times_;
  Stamp newest_ = Stamp::min();
};

}  // namespace castaway::testbed
