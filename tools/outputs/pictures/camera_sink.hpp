/// Images of a camera on the robot: colour, depth and instances.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "sim/render/renderer.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/outputs/pictures/coco.hpp"
#include "tools/outputs/pictures/picture_config.hpp"
#include "tools/outputs/pictures/picture_scenes.hpp"

namespace castaway::testbed {

/// Throws std::invalid_argument, naming the value, for an invalid camera.
void validate(const CameraConfig& config);

/// Focal length and optical centre [px]. The centre of pixel (0, 0) is at (0, 0).
struct Intrinsics {
  double f = 1.0;
  double cx = 0.0;
  double cy = 0.0;
};
Intrinsics intrinsics(const CameraConfig& config);

/// Pose of the camera's optical frame in base, by REP-103: z forward, x right, y down.
Eigen::Isometry3d T_base_optical(const CameraConfig& config);

/// Takes an image at the first odometry reading of every period:
///
///     camera/rgb/000000.png        8 bits a channel
///     camera/depth/000000.png      16 bits: mm along the optical axis, 0: nothing (or 65.535 m on)
///     camera/instances/000000.png  16 bits: what it shows, 0: nothing
///     camera/frames.csv            frame, stamp_s, true pose of the optical frame in map
///     camera/camera.json           size, intrinsics, T_base_optical, units
///     camera/instances.json        what the numbers mean that occur
///     camera/coco.json             people: boxes and masks
class CameraSink final : public RunSink {
 public:
  /// `names`: names of instances, besides floor, robot and people. Throws std::runtime_error if EGL
  /// is not available, std::invalid_argument for an invalid camera.
  CameraSink(const std::filesystem::path& run_folder, const CameraConfig& config,
             PictureWorld world, std::map<int, std::string> names);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame& frame) override;
  void on_scan(const ScanRecord&) override {}
  void finish(Stamp, const RunTiming&) override;

 private:
  void take(Stamp stamp, const SE2& T_map_base);
  void save(const sim::LabelledView& view, const std::string& name) const;
  void write_camera() const;

  std::filesystem::path folder_;
  CameraConfig config_;
  PictureWorld world_;
  std::map<int, std::string> names_;
  sim::Renderer renderer_;
  CsvWriter frames_;
  CocoFile coco_;
  std::set<std::uint16_t> seen_;
  std::optional<Stamp> next_;
  int taken_ = 0;
};

}  // namespace castaway::testbed
