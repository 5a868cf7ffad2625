/// Messages of ROS 2, written from its public .msg files, in Fast CDR: none of it is castaway's.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <fastcdr/Cdr.h>

namespace castaway::peer {

using eprosima::fastcdr::Cdr;

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  [[nodiscard]] std::int64_t ns() const { return std::int64_t{sec} * 1'000'000'000 + nanosec; }
  static void visit(auto& m, auto&& visitor) { visitor(m.sec, m.nanosec); }
};
struct Header {
  Time stamp;
  std::string frame_id;
  static void visit(auto& m, auto&& visitor) { visitor(m.stamp, m.frame_id); }
};
struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
  static void visit(auto& m, auto&& visitor) { visitor(m.x, m.y, m.z); }
};
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
  static void visit(auto& m, auto&& visitor) { visitor(m.x, m.y, m.z, m.w); }
};
struct Pose {
  Vector3 position;
  Quaternion orientation;
  static void visit(auto& m, auto&& visitor) { visitor(m.position, m.orientation); }
};
struct PoseWithCovariance {
  Pose pose;
  std::array<double, 36> covariance{};
  static void visit(auto& m, auto&& visitor) { visitor(m.pose, m.covariance); }
};
struct PoseWithCovarianceStamped {
  static constexpr const char* kType = "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_";
  Header header;
  PoseWithCovariance pose;
  static void visit(auto& m, auto&& visitor) { visitor(m.header, m.pose); }
};
struct TransformStamped {
  Header header;
  std::string child_frame_id;
  Vector3 translation;
  Quaternion rotation;
  static void visit(auto& m, auto&& visitor) {
    visitor(m.header, m.child_frame_id, m.translation, m.rotation);
  }
};
struct TFMessage {
  static constexpr const char* kType = "tf2_msgs::msg::dds_::TFMessage_";
  std::vector<TransformStamped> transforms;
  static void visit(auto& m, auto&& visitor) { visitor(m.transforms); }
};
struct Clock {
  static constexpr const char* kType = "rosgraph_msgs::msg::dds_::Clock_";
  Time clock;
  static void visit(auto& m, auto&& visitor) { visitor(m.clock); }
};
struct String {
  static constexpr const char* kType = "std_msgs::msg::dds_::String_";
  std::string data;
  static void visit(auto& m, auto&& visitor) { visitor(m.data); }
};
struct LaserScan {
  static constexpr const char* kType = "sensor_msgs::msg::dds_::LaserScan_";
  Header header;
  float angle_min = 0, angle_max = 0, angle_increment = 0, time_increment = 0, scan_time = 0;
  float range_min = 0, range_max = 0;
  std::vector<float> ranges, intensities;
  static void visit(auto& m, auto&& visitor) {
    visitor(m.header, m.angle_min, m.angle_max, m.angle_increment, m.time_increment, m.scan_time,
            m.range_min, m.range_max, m.ranges, m.intensities);
  }
};
struct PointField {
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
  static void visit(auto& m, auto&& visitor) { visitor(m.name, m.offset, m.datatype, m.count); }
};
struct PointCloud2 {
  static constexpr const char* kType = "sensor_msgs::msg::dds_::PointCloud2_";
  Header header;
  std::uint32_t height = 0, width = 0;
  std::vector<PointField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0, row_step = 0;
  std::vector<std::uint8_t> data;
  bool is_dense = false;
  static void visit(auto& m, auto&& visitor) {
    visitor(m.header, m.height, m.width, m.fields, m.is_bigendian, m.point_step, m.row_step, m.data,
            m.is_dense);
  }
};
struct Imu {
  static constexpr const char* kType = "sensor_msgs::msg::dds_::Imu_";
  Header header;
  Quaternion orientation;
  std::array<double, 9> orientation_covariance{};
  Vector3 angular_velocity;
  std::array<double, 9> angular_velocity_covariance{};
  Vector3 linear_acceleration;
  std::array<double, 9> linear_acceleration_covariance{};
  static void visit(auto& m, auto&& visitor) {
    visitor(m.header, m.orientation, m.orientation_covariance, m.angular_velocity,
            m.angular_velocity_covariance, m.linear_acceleration, m.linear_acceleration_covariance);
  }
};
struct Odometry {
  static constexpr const char* kType = "nav_msgs::msg::dds_::Odometry_";
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  Vector3 linear, angular;
  std::array<double, 36> twist_covariance{};
  static void visit(auto& m, auto&& visitor) {
    visitor(m.header, m.child_frame_id, m.pose, m.linear, m.angular, m.twist_covariance);
  }
};
struct Twist {
  static constexpr const char* kType = "geometry_msgs::msg::dds_::Twist_";
  Vector3 linear, angular;
  static void visit(auto& m, auto&& visitor) { visitor(m.linear, m.angular); }
};
struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs::msg::dds_::TwistStamped_";
  Header header;
  Twist twist;
  static void visit(auto& m, auto&& visitor) { visitor(m.header, m.twist); }
};
struct OccupancyGrid {
  static constexpr const char* kType = "nav_msgs::msg::dds_::OccupancyGrid_";
  Header header;
  Time map_load_time;
  float resolution = 0;
  std::uint32_t width = 0, height = 0;
  Pose origin;
  std::vector<std::int8_t> data;
  static void visit(auto& m, auto&& visitor) {
    visitor(m.header, m.map_load_time, m.resolution, m.width, m.height, m.origin, m.data);
  }
};
struct Particle {
  Pose pose;
  double weight = 1.0;
  static void visit(auto& m, auto&& visitor) { visitor(m.pose, m.weight); }
};
struct ParticleCloud {
  static constexpr const char* kType = "nav2_msgs::msg::dds_::ParticleCloud_";
  Header header;
  std::vector<Particle> particles;
  static void visit(auto& m, auto&& visitor) { visitor(m.header, m.particles); }
};

/// Writes and reads numbers, texts and lists by Fast CDR, messages field by field.
template <typename T>
void put(Cdr& cdr, const T& value) {
  if constexpr (requires { T::visit(value, [](const auto&...) {}); }) {
    T::visit(value, [&](const auto&... each) { (put(cdr, each), ...); });
  } else {
    cdr << value;
  }
}
template <typename T>
void put(Cdr& cdr, const std::vector<T>& values) {
  cdr << static_cast<std::uint32_t>(values.size());
  for (const T& value : values) put(cdr, value);
}

template <typename T>
void get(Cdr& cdr, T& value) {
  if constexpr (requires { T::visit(value, [](auto&...) {}); }) {
    T::visit(value, [&](auto&... each) { (get(cdr, each), ...); });
  } else {
    cdr >> value;
  }
}
template <typename T>
void get(Cdr& cdr, std::vector<T>& values) {
  std::uint32_t count = 0;
  cdr >> count;
  values.clear();
  for (std::uint32_t i = 0; i < count; ++i) get(cdr, values.emplace_back());
}

}  // namespace castaway::peer
