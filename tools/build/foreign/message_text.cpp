#include "tools/build/foreign/message_text.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <openssl/evp.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json pose_json(const SE2& pose) { return Json::array({pose.x, pose.y, pose.yaw}); }

std::string base64(const std::vector<std::int8_t>& cells) {
  std::string text(4 * ((cells.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(cells.data()),
                                     static_cast<int>(cells.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

Json map_json(const Greeting& greeting) {
  const RosMap& map = greeting.map;
  return {{"name", map.name},
          {"file", greeting.map_file.empty() ? Json() : Json(greeting.map_file)},
          {"width", map.width},
          {"height", map.height},
          {"resolution", map.resolution},
          {"origin", {map.origin_x, map.origin_y, map.origin_yaw}},
          {"cells", base64(map.cells)}};
}

/// Translation, and rotations about the fixed axes x, y, z in this order, as in a URDF.
Json mount_json(const Eigen::Isometry3d& T_base_laser) {
  const Eigen::Matrix3d R = T_base_laser.linear();
  const Eigen::Vector3d p = T_base_laser.translation();
  return {{"x", p.x()},
          {"y", p.y()},
          {"z", p.z()},
          {"roll", std::atan2(R(2, 1), R(2, 2))},
          {"pitch", std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)))},
          {"yaw", std::atan2(R(1, 0), R(0, 0))}};
}

Json matrix_json(const Eigen::Isometry3d& T_base_laser) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows.push_back(T_base_laser(row, column));
  }
  return rows;
}

Json lidar_json(const LidarFacts& lidar) {
  return {{"name", lidar.name},
          {"mount", mount_json(lidar.T_base_laser)},
          {"T_base_laser", matrix_json(lidar.T_base_laser)},
          {"angle_min", lidar.angle_min},
          {"angle_increment", lidar.angle_increment},
          {"range_min", lidar.range_min},
          {"range_max", lidar.range_max},
          {"beams", lidar.beams}};
}

/// Text of other origin may hold bytes that are not UTF-8.
void append_line(const Json& message, std::string& text) {
  text += json_text(message);
  text += '\n';
}

void append_range(float range, std::string& text) {
  if (std::isfinite(range) && range >= 0.0F) {
    fmt::format_to(std::back_inserter(text), "{}", range);
  } else {
    text += std::isinf(range) && range > 0.0F ? "null" : "-1";
  }
}

}  // namespace

void append_hello(const Greeting& greeting, const std::string& params, std::string& text) {
  Json lidars = Json::array();
  for (const LidarFacts& lidar : greeting.lidars) lidars.push_back(lidar_json(lidar));
  append_line({{"type", "hello"},
               {"protocol", kProtocolVersion},
               {"name", greeting.name},
               {"seed", greeting.seed},
               {"map", map_json(greeting)},
               {"lidars", std::move(lidars)},
               {"params", Json::parse(params)}},
              text);
}

void append_lidar(const LidarFacts& lidar, std::string& text) {
  append_line({{"type", "lidar"}, {"lidar", lidar_json(lidar)}}, text);
}

void append_initialize(const std::optional<localization::PoseWithCovariance>& start,
                       std::string& text) {
  Json message{{"type", "initialize"}, {"pose", nullptr}, {"covariance", nullptr}};
  if (start) {
    message["pose"] = pose_json(start->T_map_base);
    message["covariance"] = Json::array();
    for (int i = 0; i < 9; ++i) message["covariance"].push_back(start->covariance(i / 3, i % 3));
  }
  append_line(message, text);
}

void append_odometry(const Odometry& odometry, const Eigen::Vector3d& twist, std::string& text) {
  const SE2& pose = odometry.T_odom_base;
  fmt::format_to(std::back_inserter(text),
                 R"({{"type":"odometry","stamp_ns":{},"pose":[{},{},{}],"twist":[{},{},{}]}})"
                 "\n",
                 odometry.stamp.count(), pose.x, pose.y, pose.yaw, twist.x(), twist.y(), twist.z());
}

void append_scan(const LaserScan& scan, std::string& text) {
  text += R"({"type":"scan","stamp_ns":)";
  fmt::format_to(std::back_inserter(text), "{}", scan.stamp.count());
  text += R"(,"lidar":)" + json_text(Json(scan.lidar));
  fmt::format_to(std::back_inserter(text), R"(,"time_increment_s":{},"ranges":[)",
                 localization::seconds(scan.time_increment));
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (i > 0) text += ',';
    append_range(scan.ranges[i], text);
  }
  text += "]}\n";
}

void append_bye(std::string& text) { append_line({{"type", "bye"}}, text); }

}  // namespace castaway::testbed
