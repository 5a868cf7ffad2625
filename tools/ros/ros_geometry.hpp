/// Messages of geometry_msgs and tf2_msgs, as ROS 2 defines them. See `ros_message.hpp`.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/ros/ros_std.hpp"

namespace castaway::testbed::ros {

/// A point. [m]
struct Point {
  static constexpr const char* kType = "geometry_msgs/msg/Point";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("x", self.x);
    visitor("y", self.y);
    visitor("z", self.z);
  }
};

/// A vector; its unit depends on its use.
struct Vector3 {
  static constexpr const char* kType = "geometry_msgs/msg/Vector3";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("x", self.x);
    visitor("y", self.y);
    visitor("z", self.z);
  }
};

/// A rotation.
struct Quaternion {
  static constexpr const char* kType = "geometry_msgs/msg/Quaternion";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("x", self.x);
    visitor("y", self.y);
    visitor("z", self.z);
    visitor("w", self.w);
  }
};

/// Position [m] and orientation.
struct Pose {
  static constexpr const char* kType = "geometry_msgs/msg/Pose";
  Point position;
  Quaternion orientation;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("position", self.position);
    visitor("orientation", self.orientation);
  }
};

/// A pose in a frame at a time.
struct PoseStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseStamped";
  Header header;
  Pose pose;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("pose", self.pose);
  }
};

/// Poses in a frame at a time.
struct PoseArray {
  static constexpr const char* kType = "geometry_msgs/msg/PoseArray";
  Header header;
  std::vector<Pose> poses;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("poses", self.poses);
  }
};

/// A pose and how sure it is.
struct PoseWithCovariance {
  static constexpr const char* kType = "geometry_msgs/msg/PoseWithCovariance";
  Pose pose;
  std::array<double, 36>
      covariance{};  ///< Row by row of x, y, z, rotations about x, y, z. [m, rad]

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("pose", self.pose);
    visitor("covariance", self.covariance);
  }
};

/// The same in a frame at a time.
struct PoseWithCovarianceStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseWithCovarianceStamped";
  Header header;
  PoseWithCovariance pose;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("pose", self.pose);
  }
};

/// Velocities.
struct Twist {
  static constexpr const char* kType = "geometry_msgs/msg/Twist";
  Vector3 linear;   ///< [m/s]
  Vector3 angular;  ///< [rad/s]

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("linear", self.linear);
    visitor("angular", self.angular);
  }
};

/// A velocity at a time.
struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TwistStamped";
  Header header;
  Twist twist;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("twist", self.twist);
  }
};

/// Velocities and how sure they are.
struct TwistWithCovariance {
  static constexpr const char* kType = "geometry_msgs/msg/TwistWithCovariance";
  Twist twist;
  std::array<double, 36> covariance{};

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("twist", self.twist);
    visitor("covariance", self.covariance);
  }
};

/// Moves points of the child into the parent.
struct Transform {
  static constexpr const char* kType = "geometry_msgs/msg/Transform";
  Vector3 translation;  ///< [m]
  Quaternion rotation;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("translation", self.translation);
    visitor("rotation", self.rotation);
  }
};

/// The pose of a frame in its parent (the header's frame) at a time.
struct TransformStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TransformStamped";
  Header header;
  std::string child_frame_id;
  Transform transform;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("child_frame_id", self.child_frame_id);
    visitor("transform", self.transform);
  }
};

/// Edges of the tree of frames.
struct TFMessage {
  static constexpr const char* kType = "tf2_msgs/msg/TFMessage";
  std::vector<TransformStamped> transforms;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("transforms", self.transforms);
  }
};

}  // namespace castaway::testbed::ros
