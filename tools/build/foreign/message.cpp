#include "tools/build/foreign/message.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <openssl/evp.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using localization::Stamp;

SE2 pose_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

std::vector<std::int8_t> cells_of(const std::string& base64, std::size_t count) {
  std::vector<std::int8_t> cells(base64.size() / 4 * 3);
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(cells.data()),
                                   reinterpret_cast<const unsigned char*>(base64.data()),
                                   static_cast<int>(base64.size()));
  if (size < 0 || static_cast<std::size_t>(size) < count) {
    throw std::runtime_error("the cells of the map are not base64, or too few");
  }
  cells.resize(count);
  return cells;
}

RosMap map_of_message(const Json& json) {
  RosMap map;
  map.name = json.at("name");
  map.width = json.at("width");
  map.height = json.at("height");
  map.resolution = json.at("resolution");
  const SE2 origin = pose_of(json.at("origin"));
  map.origin_x = origin.x;
  map.origin_y = origin.y;
  map.origin_yaw = origin.yaw;
  map.cells = cells_of(json.at("cells"),
                       static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  return map;
}

LidarFacts lidar_of_message(const Json& json) {
  LidarFacts lidar;
  lidar.name = json.at("name");
  for (int i = 0; i < 12; ++i) {
    lidar.T_base_laser(i / 4, i % 4) =
        json.at("T_base_laser").at(static_cast<std::size_t>(i)).get<double>();
  }
  lidar.angle_min = json.at("angle_min");
  lidar.angle_increment = json.at("angle_increment");
  lidar.range_min = json.at("range_min");
  lidar.range_max = json.at("range_max");
  lidar.beams = json.at("beams");
  return lidar;
}

Greeting greeting_of_message(const Json& json) {
  Greeting greeting;
  if (json.at("protocol") != kProtocolVersion) throw std::runtime_error("another protocol");
  greeting.name = json.at("name");
  greeting.seed = json.at("seed");
  greeting.map = map_of_message(json.at("map"));
  if (json.at("map").at("file").is_string()) greeting.map_file = json.at("map").at("file");
  for (const Json& lidar : json.at("lidars")) greeting.lidars.push_back(lidar_of_message(lidar));
  return greeting;
}

StartMessage start_of_message(const Json& json) {
  if (json.at("pose").is_null()) return {};
  localization::PoseWithCovariance start{pose_of(json.at("pose"))};
  for (int i = 0; i < 9; ++i) {
    start.covariance(i / 3, i % 3) =
        json.at("covariance").at(static_cast<std::size_t>(i)).get<double>();
  }
  return {start};
}

float range_of(const Json& json) {
  if (json.is_null()) return std::numeric_limits<float>::infinity();
  const auto range = json.get<float>();
  return range < 0.0F ? std::numeric_limits<float>::quiet_NaN() : range;
}

LaserScan scan_of_message(const Json& json, const std::vector<LidarFacts>& lidars) {
  LaserScan scan;
  scan.lidar = json.at("lidar");
  const auto lidar = std::find_if(lidars.begin(), lidars.end(), [&](const LidarFacts& known) {
    return known.name == scan.lidar;
  });
  if (lidar == lidars.end()) throw std::runtime_error("a scan of a lidar that was not announced");
  scan.stamp = Stamp(json.at("stamp_ns").get<std::int64_t>());
  scan.time_increment = localization::from_seconds(json.at("time_increment_s"));
  scan.angle_min = lidar->angle_min;
  scan.angle_increment = lidar->angle_increment;
  scan.range_min = lidar->range_min;
  scan.range_max = lidar->range_max;
  scan.T_base_laser = lidar->T_base_laser;
  for (const Json& range : json.at("ranges")) scan.ranges.push_back(range_of(range));
  return scan;
}

void keep(const LidarFacts& lidar, std::vector<LidarFacts>& lidars) {
  const auto same = [&](const LidarFacts& known) { return known.name == lidar.name; };
  std::erase_if(lidars, same);
  lidars.push_back(lidar);
}

Json pose_list(const SE2& pose) { return Json::array({pose.x, pose.y, pose.yaw}); }

}  // namespace

Message MessageReader::read(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    const std::string type = json.at("type");
    if (type == "hello") {
      Greeting greeting = greeting_of_message(json);
      lidars_ = greeting.lidars;
      return greeting;
    }
    if (type == "lidar") {
      LidarFacts lidar = lidar_of_message(json.at("lidar"));
      keep(lidar, lidars_);
      return lidar;
    }
    if (type == "initialize") return start_of_message(json);
    if (type == "odometry") {
      return Odometry{Stamp(json.at("stamp_ns").get<std::int64_t>()), pose_of(json.at("pose"))};
    }
    if (type == "scan") return scan_of_message(json, lidars_);
    if (type == "bye") return ByeMessage{};
    throw std::runtime_error("a message of the unknown type '" + type + "'");
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("a message that is not of the protocol: ") + error.what());
  }
}

std::string ready_text() {
  return json_text(Json{{"type", "ready"}, {"protocol", kProtocolVersion}}) + "\n";
}

std::string estimate_text(Stamp stamp, const std::optional<localization::Estimate>& estimate) {
  Json json{{"type", "estimate"}, {"stamp_ns", stamp.count()}};
  if (estimate) {
    json["pose"] = pose_list(estimate->T_map_base);
    json["covariance"] = Json::array();
    for (int i = 0; i < 9; ++i) json["covariance"].push_back(estimate->covariance(i / 3, i % 3));
    if (!std::isnan(estimate->probability)) {
      json["probability"] = std::clamp(estimate->probability, 0.0, 1.0);
    }
    if (!std::isnan(estimate->quality)) json["quality"] = std::clamp(estimate->quality, 0.0, 1.0);
    json["lost"] = estimate->lost;
    json["hypotheses"] = Json::array();
    for (const auto& other : estimate->alternatives) {
      json["hypotheses"].push_back({{"pose", pose_list(other.T_map_base)},
                                    {"probability", std::clamp(other.share, 0.0, 1.0)}});
    }
  }
  return json_text(json) + "\n";
}

}  // namespace castaway::testbed
