/// Messages of builtin_interfaces and std_msgs, as ROS 2 defines them. See `ros_message.hpp`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed::ros {

/// Time since the epoch.
struct Time {
  static constexpr const char* kType = "builtin_interfaces/msg/Time";
  std::int32_t sec = 0;       ///< [s]
  std::uint32_t nanosec = 0;  ///< [ns] Below 1e9.

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("sec", self.sec);
    visitor("nanosec", self.nanosec);
  }
};

/// A length of time.
struct Duration {
  static constexpr const char* kType = "builtin_interfaces/msg/Duration";
  std::int32_t sec = 0;       ///< [s]
  std::uint32_t nanosec = 0;  ///< [ns] Below 1e9.

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("sec", self.sec);
    visitor("nanosec", self.nanosec);
  }
};

/// When and in which frame.
struct Header {
  static constexpr const char* kType = "std_msgs/msg/Header";
  Time stamp;
  std::string frame_id;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("stamp", self.stamp);
    visitor("frame_id", self.frame_id);
  }
};

/// A text.
struct String {
  static constexpr const char* kType = "std_msgs/msg/String";
  std::string data;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("data", self.data);
  }
};

/// A colour; parts in [0, 1].
struct ColorRGBA {
  static constexpr const char* kType = "std_msgs/msg/ColorRGBA";
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
  float a = 0.0F;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("r", self.r);
    visitor("g", self.g);
    visitor("b", self.b);
    visitor("a", self.a);
  }
};

/// A dimension of an array.
struct MultiArrayDimension {
  static constexpr const char* kType = "std_msgs/msg/MultiArrayDimension";
  std::string label;
  std::uint32_t size = 0;
  std::uint32_t stride = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("label", self.label);
    visitor("size", self.size);
    visitor("stride", self.stride);
  }
};

/// The shape of an array.
struct MultiArrayLayout {
  static constexpr const char* kType = "std_msgs/msg/MultiArrayLayout";
  std::vector<MultiArrayDimension> dim;
  std::uint32_t data_offset = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("dim", self.dim);
    visitor("data_offset", self.data_offset);
  }
};

/// Whole numbers.
struct Int32MultiArray {
  static constexpr const char* kType = "std_msgs/msg/Int32MultiArray";
  MultiArrayLayout layout;
  std::vector<std::int32_t> data;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("layout", self.layout);
    visitor("data", self.data);
  }
};

}  // namespace castaway::testbed::ros
