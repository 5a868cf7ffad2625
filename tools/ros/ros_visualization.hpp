/// Messages of visualization_msgs, as ROS 2 defines them from Humble on. See `ros_message.hpp`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed::ros {

/// A point of a texture.
struct UVCoordinate {
  static constexpr const char* kType = "visualization_msgs/msg/UVCoordinate";
  float u = 0.0F;
  float v = 0.0F;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("u", self.u);
    visitor("v", self.v);
  }
};

/// A mesh within the message.
struct MeshFile {
  static constexpr const char* kType = "visualization_msgs/msg/MeshFile";
  std::string filename;
  std::vector<std::uint8_t> data;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("filename", self.filename);
    visitor("data", self.data);
  }
};

/// A thing to draw.
struct Marker {
  static constexpr const char* kType = "visualization_msgs/msg/Marker";
  Header header;
  std::string ns;
  std::int32_t id = 0;
  std::int32_t type = 0;    ///< 0 arrow, 3 cylinder, 9 text that faces the viewer.
  std::int32_t action = 0;  ///< 0 add, 3 delete all.
  Pose pose;
  Vector3 scale;  ///< [m]
  ColorRGBA color;
  Duration lifetime;
  bool frame_locked = false;
  std::vector<Point> points;
  std::vector<ColorRGBA> colors;
  std::string texture_resource;
  CompressedImage texture;
  std::vector<UVCoordinate> uv_coordinates;
  std::string text;
  std::string mesh_resource;
  MeshFile mesh_file;
  bool mesh_use_embedded_materials = false;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("header", self.header);
    visitor("ns", self.ns);
    visitor("id", self.id);
    visitor("type", self.type);
    visitor("action", self.action);
    visitor("pose", self.pose);
    visitor("scale", self.scale);
    visitor("color", self.color);
    visitor("lifetime", self.lifetime);
    visitor("frame_locked", self.frame_locked);
    visitor("points", self.points);
    visitor("colors", self.colors);
    visitor("texture_resource", self.texture_resource);
    visitor("texture", self.texture);
    visitor("uv_coordinates", self.uv_coordinates);
    visitor("text", self.text);
    visitor("mesh_resource", self.mesh_resource);
    visitor("mesh_file", self.mesh_file);
    visitor("mesh_use_embedded_materials", self.mesh_use_embedded_materials);
  }
};

/// Things to draw.
struct MarkerArray {
  static constexpr const char* kType = "visualization_msgs/msg/MarkerArray";
  std::vector<Marker> markers;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("markers", self.markers);
  }
};

}  // namespace castaway::testbed::ros
