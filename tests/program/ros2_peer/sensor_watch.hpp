/// Takes an inertial measurement unit and a 3-D lidar from the wire, as a node subscribes to them.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tests/program/ros2_peer/wire.hpp"

namespace castaway::peer {

/// Subscribes with ROS 2's quality of service for sensor data, and describes what came.
class SensorWatch {
 public:
  /// Names of the topics; empty: none.
  SensorWatch(Wire& wire, const std::string& imu, const std::string& points);

  /// Takes what has come. Returns true if there was anything.
  bool turn();
  /// Readings, frame and the first stamp; the least difference of two stamps; the sums of the
  /// specific force; and whether orientations are declared as unknown.
  [[nodiscard]] const nlohmann::json& imu() const { return imu_; }
  /// Clouds, frame, rows, columns and fields of the newest; points with a return, and how many of
  /// these are not where their field `range` says.
  [[nodiscard]] const nlohmann::json& points() const { return points_; }

 private:
  void note(const Imu& imu);
  void note(const PointCloud2& cloud);

  dds::DataReader* imu_reader_ = nullptr;
  dds::DataReader* points_reader_ = nullptr;
  nlohmann::json imu_;
  nlohmann::json points_;
  std::int64_t newest_ns_ = -1;
};

}  // namespace castaway::peer
