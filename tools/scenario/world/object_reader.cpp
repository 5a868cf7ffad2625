#include "tools/scenario/world/object_reader.hpp"

#include <numbers>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr double kMaxLength = 1000.0;  // [m]

}  // namespace

double positive(YamlReader& reader, const std::string& key, double fallback) {
  const double value = reader.get(key, fallback);
  if (value <= 0.0) reader.find(key)->fail("must be above 0 (metres)");
  if (value > kMaxLength) reader.find(key)->fail("is more than 1000 m; lengths are in metres");
  return value;
}

double required_positive(YamlReader& reader, const std::string& key) {
  (void)reader.require<double>(key);
  return positive(reader, key, 1.0);
}

Eigen::Vector3d size_of(YamlReader& reader) {
  auto size = reader.require<Eigen::Vector3d>("size");
  if (size.minCoeff() <= 0.0) reader.find("size")->fail("each edge must be above 0 (metres)");
  if (size.maxCoeff() > kMaxLength) {
    reader.find("size")->fail("an edge of more than 1000 m; lengths are in metres");
  }
  return size;
}

Eigen::Isometry3d floor_frame(YamlReader& reader) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const auto at = reader.require<Eigen::Vector2d>("at");
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << at, reader.get("bottom", 0.0);
  T.rotate(Eigen::AngleAxisd(reader.get("yaw_deg", 0.0) * kDegree, Eigen::Vector3d::UnitZ()));
  return T;
}

Eigen::Isometry3d translate(const Eigen::Isometry3d& T, const Eigen::Vector3d& by) {
  return T * Eigen::Translation3d(by);
}

sim::WorldObject body(sim::ObjectShape shape, const Eigen::Isometry3d& T_map_object) {
  return {"", std::move(shape), T_map_object};
}

sim::WorldObject box_at(const Eigen::Isometry3d& T, const Eigen::Vector3d& p,
                        const Eigen::Vector3d& size) {
  return body(sim::BoxShape{size}, translate(T, p + Eigen::Vector3d(0.0, 0.0, 0.5 * size.z())));
}

}  // namespace castaway::testbed
