/// log.carmen: a run as a CARMEN log.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "localization/geometry/transform_buffer.hpp"
#include "tools/base/files/file.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// The scan projected into the plane of base: the mount as x, y, yaw, with the beams of an
/// upside-down lidar reversed. Tilt is ignored.
struct PlanarScan {
  SE2 T_base_laser;
  double angle_min = 0.0;  ///< [rad]
  std::vector<float> ranges;
};
PlanarScan planar_view(const LaserScan& scan);

/// Writes ODOM for odometry; for scans ROBOTLASER1, 2... by lidar, each followed by TRUEPOS; and
/// PARAM with the maximum range of the first lidar. Lines are sorted by their stamps. The format
/// cannot hold the time of each beam, heights and events.
class CarmenSink final : public RunSink {
 public:
  explicit CarmenSink(const std::filesystem::path& run_folder) : file_(run_folder / "log.carmen") {}

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame& frame) override;
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  void write_up_to(Stamp stamp);
  int number_of(const LaserScan& scan);

  AtomicFile file_;
  std::multimap<Stamp, std::string> waiting_;  ///< Lines that an older scan may still precede.
  localization::TransformBuffer T_odom_base_;
  std::map<std::string, int> lidars_;
  std::optional<Odometry> last_;
  double speed_ = 0.0;
  double turn_rate_ = 0.0;
};

}  // namespace castaway::testbed
