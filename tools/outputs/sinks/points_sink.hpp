/// PLY files: point clouds of the lidars.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Writes points/<lidar>-<stamp in ms>.ply for the first scan of each lidar in every period of
/// `every_s` seconds: the returns of all layers in base as ASCII PLY with x, y, z [m], intensity
/// and label.
class PointsSink final : public RunSink {
 public:
  /// `every_s` [s]: above 0.
  PointsSink(const std::filesystem::path& run_folder, double every_s);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override {}

 private:
  std::filesystem::path folder_;
  Stamp period_;
  std::map<std::string, Stamp> next_;  ///< By lidar.
};

/// A cloud as ASCII PLY.
std::string ply_text(const std::vector<CloudPoint>& cloud);

}  // namespace castaway::testbed
