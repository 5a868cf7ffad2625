#include "tools/outputs/pictures/camera_sink.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

CameraConfig require_valid(const CameraConfig& config) {
  validate(config);
  return config;
}

Eigen::Isometry3d T_base_camera(const CameraConfig& config) {
  return Eigen::Translation3d(config.p_base) *
         Eigen::Isometry3d(Eigen::AngleAxisd(config.rpy.z(), Eigen::Vector3d::UnitZ()) *
                           Eigen::AngleAxisd(config.rpy.y(), Eigen::Vector3d::UnitY()) *
                           Eigen::AngleAxisd(config.rpy.x(), Eigen::Vector3d::UnitX()));
}

sim::Camera camera_at(const CameraConfig& config, const Eigen::Isometry3d& T_map_optical) {
  const double aspect = static_cast<double>(config.width) / config.height;
  sim::Camera camera;
  camera.eye = T_map_optical.translation().cast<float>();
  camera.target = (T_map_optical * Eigen::Vector3d::UnitZ()).cast<float>();
  camera.up = (-T_map_optical.linear().col(1)).cast<float>();
  camera.fov_y_deg = static_cast<float>(
      2.0 * std::atan(std::tan(0.5 * config.fov_deg * kDegree) / aspect) / kDegree);
  return camera;
}

sim::DeepImage in_millimetres(const sim::LabelledView& view) {
  sim::DeepImage image{view.color.width, view.color.height, {}};
  for (const float depth : view.depth_m) {
    const float mm = 1000.0F * depth;
    image.pixels.push_back(mm < 65535.0F ? static_cast<std::uint16_t>(std::lround(mm)) : 0);
  }
  return image;
}

Json pose_json(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  const Eigen::Vector3d p = T.translation();
  return {{"translation_m", {p.x(), p.y(), p.z()}},
          {"rotation_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

const char* class_of(int instance) {
  if (instance >= sim::kFirstPersonInstance) return "person";
  if (instance >= sim::kFirstObjectInstance) return "object";
  return instance == sim::kRobotInstance ? "robot" : "floor";
}

std::string name_of(int instance, const std::map<int, std::string>& names) {
  if (const auto found = names.find(instance); found != names.end()) return found->second;
  if (instance >= sim::kFirstPersonInstance) {
    return fmt::format("person {}", instance - sim::kFirstPersonInstance);
  }
  return class_of(instance);
}

}  // namespace

void validate(const CameraConfig& config) {
  const auto refuse = [](const std::string& what) {
    throw std::invalid_argument("camera: " + what);
  };
  if (!(config.rate_hz > 0.0 && config.rate_hz <= 100.0)) {
    refuse(fmt::format("rate_hz is {}: give more than 0 and at most 100", config.rate_hz));
  }
  for (const int size : {config.width, config.height}) {
    if (size < 16 || size > 4096) {
      refuse(fmt::format("{} x {} px: give 16 to 4096 each way", config.width, config.height));
    }
  }
  if (!(config.fov_deg >= 5.0 && config.fov_deg <= 150.0)) {
    refuse(fmt::format("fov_deg is {}: give 5 to 150", config.fov_deg));
  }
}

Intrinsics intrinsics(const CameraConfig& config) {
  return {0.5 * config.width / std::tan(0.5 * config.fov_deg * kDegree), 0.5 * (config.width - 1),
          0.5 * (config.height - 1)};
}

Eigen::Isometry3d T_base_optical(const CameraConfig& config) {
  Eigen::Isometry3d T_camera_optical = Eigen::Isometry3d::Identity();
  T_camera_optical.linear() << 0.0, 0.0, 1.0,  //
      -1.0, 0.0, 0.0,                          //
      0.0, -1.0, 0.0;
  return T_base_camera(config) * T_camera_optical;
}

CameraSink::CameraSink(const std::filesystem::path& run_folder, const CameraConfig& config,
                       PictureWorld world, std::map<int, std::string> names)
    : folder_(run_folder / "camera"),
      config_(require_valid(config)),
      world_(std::move(world)),
      names_(std::move(names)),
      renderer_(config.width, config.height),
      frames_(folder_ / "frames.csv",
              {"frame", "stamp_s", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"}) {
  for (const char* kind : {"rgb", "depth", "instances"}) {
    const bool wanted = (kind != std::string("depth") || config_.depth) &&
                        (kind != std::string("instances") || config_.instances);
    if (wanted) std::filesystem::create_directories(folder_ / kind);
  }
}

void CameraSink::on_odometry(const OdometryFrame& frame) {
  if (!frame.true_pose) return;
  const Stamp stamp = frame.odometry.stamp;
  if (next_ && stamp < *next_) return;
  const auto period = std::chrono::nanoseconds(std::llround(1e9 / config_.rate_hz));
  next_ = next_.value_or(stamp) + period;
  take(stamp, frame.true_pose->T_map_base);
}

void CameraSink::take(Stamp stamp, const SE2& T_map_base) {
  const Eigen::Isometry3d T_map_robot = pose_in_space(world_, T_map_base);
  const Eigen::Isometry3d T_map_optical = T_map_robot * T_base_optical(config_);
  sim::Scene scene;
  scene.items = world_.world;
  for (sim::SceneItem item : world_.robot) {
    item.T_map_mesh = T_map_robot.cast<float>() * item.T_map_mesh;
    item.instance = sim::kRobotInstance;
    scene.items.push_back(std::move(item));
  }
  if (world_.moving) {
    for (sim::SceneItem& item : world_.moving()) scene.items.push_back(std::move(item));
  }
  scene.camera = camera_at(config_, T_map_optical);
  const sim::LabelledView view = renderer_.capture(scene);
  const std::string name = fmt::format("{:06d}.png", taken_);
  save(view, name);
  coco_.add("rgb/" + name, seconds(stamp), view.instances, config_.width);
  seen_.insert(view.instances.begin(), view.instances.end());
  const Eigen::Quaterniond q(T_map_optical.linear());
  frames_.count(taken_++).number(seconds(stamp), 9);
  for (const double value : T_map_optical.translation()) frames_.number(value);
  for (const double value : {q.x(), q.y(), q.z(), q.w()}) frames_.number(value, 9);
  frames_.end_row();
}

void CameraSink::save(const sim::LabelledView& view, const std::string& name) const {
  write_file(folder_ / "rgb" / name, sim::encode_png(view.color));
  if (config_.depth)
    write_file(folder_ / "depth" / name, sim::encode_deep_png(in_millimetres(view)));
  if (!config_.instances) return;
  const sim::DeepImage labels{view.color.width, view.color.height, view.instances};
  write_file(folder_ / "instances" / name, sim::encode_deep_png(labels));
}

void CameraSink::write_camera() const {
  const Intrinsics k = intrinsics(config_);
  const Json json{{"width", config_.width},
                  {"height", config_.height},
                  {"fx", k.f},
                  {"fy", k.f},
                  {"cx", k.cx},
                  {"cy", k.cy},
                  {"distortion", Json::array()},
                  {"rate_hz", config_.rate_hz},
                  {"T_base_optical", pose_json(T_base_optical(config_))},
                  {"optical_frame", "z ahead, x to the right, y down (REP-103)"},
                  {"depth", "uint16, mm along z, 0: nothing"},
                  {"instances", "uint16, instances.json says what; 0: nothing"}};
  write_file(folder_ / "camera.json", json_text(json, 2) + "\n");
}

void CameraSink::finish(Stamp, const RunTiming&) {
  frames_.commit();
  write_camera();
  Json instances = Json::array();
  for (const int instance : seen_) {
    if (instance == 0) continue;
    instances.push_back(
        {{"id", instance}, {"name", name_of(instance, names_)}, {"class", class_of(instance)}});
  }
  write_file(folder_ / "instances.json", json_text(instances, 1) + "\n");
  write_file(folder_ / "coco.json", coco_.text());
}

}  // namespace castaway::testbed
