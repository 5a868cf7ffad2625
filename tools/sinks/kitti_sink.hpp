/// kitti/: true poses as the KITTI odometry benchmark writes them.
#pragma once

#include <filesystem>
#include <string>

#include "tools/files/file.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// A pose of base in map as the 12 numbers of its 3 x 4 matrix, row by row, and a newline. Axes are
/// REP-103's (x forward, y left, z up), not those of KITTI's camera (z forward, x right, y down).
std::string kitti_line(const SE2& T_map_base);

/// poses.txt: a row for each scan whose truth is known; times.txt: the stamps of the same scans.
/// [s]
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
