/// The lab as shipped: it loads, it is no ordinary room, and its routes are free.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tools/scenario/world_file.hpp"

namespace castaway::testbed {
namespace {

const std::filesystem::path kLab = std::filesystem::path(CASTAWAY_SOURCE_DIR) / "worlds/lab";

constexpr double kRobotHeight = 0.35;  // [m] Whatever begins higher is driven under.
constexpr double kChairRadius = 0.31;  // [m] Half the diagonal of its seat.

/// Distance in the plane of a point from an object. [m]
double clearance(const sim::WorldObject& object, const Eigen::Vector2d& p_map) {
  const Eigen::Vector3d p =
      object.T_map_object.inverse() * Eigen::Vector3d(p_map.x(), p_map.y(), 0.0);
  if (const auto* box = std::get_if<sim::BoxShape>(&object.shape)) {
    const Eigen::Vector2d outside = p.head<2>().cwiseAbs() - 0.5 * box->size.head<2>();
    return outside.cwiseMax(0.0).norm();
  }
  const auto* cylinder = std::get_if<sim::CylinderShape>(&object.shape);
  return p.head<2>().norm() - (cylinder != nullptr ? cylinder->radius : kChairRadius);
}

double underside(const sim::WorldObject& object) {
  const double z = object.T_map_object.translation().z();
  if (const auto* box = std::get_if<sim::BoxShape>(&object.shape)) return z - 0.5 * box->size.z();
  const auto* cylinder = std::get_if<sim::CylinderShape>(&object.shape);
  return z - (cylinder != nullptr ? 0.5 * cylinder->height : 0.0);
}

/// Points every 2 cm of a closed route.
std::vector<Eigen::Vector2d> sampled(const std::vector<Eigen::Vector2d>& route) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d& from = route[i];
    const Eigen::Vector2d& to = route[(i + 1) % route.size()];
    const int steps = static_cast<int>((to - from).norm() / 0.02) + 1;
    for (int k = 0; k < steps; ++k) points.push_back(from + (to - from) * k / steps);
  }
  return points;
}

TEST(LabWorld, HasRoutesAndAMap) {
  const WorldFile lab = load_world(kLab);
  EXPECT_EQ(lab.spec.name, "lab");
  EXPECT_EQ((lab.spec.max_corner - lab.spec.min_corner), Eigen::Vector2d(10.5, 10.0));
  EXPECT_TRUE(lab.routes.contains("loop"));
  EXPECT_TRUE(lab.routes.contains("workshop"));
  EXPECT_EQ(lab.map, kLab / "map.yaml");
  EXPECT_GT(lab.spec.objects.size(), 50U);
}

TEST(LabWorld, RoutesKeepTheirDistance) {
  const WorldFile lab = load_world(kLab);
  for (const auto& [name, route] : lab.routes) {
    for (const Eigen::Vector2d& point : sampled(route)) {
      for (const sim::WorldObject& object : lab.spec.objects) {
        if (underside(object) > kRobotHeight) continue;
        ASSERT_GT(clearance(object, point), 0.42)
            << name << " passes " << object.name << " at " << point.transpose();
      }
    }
  }
}

TEST(LabWorld, LiesWithinItsExtent) {
  const WorldFile lab = load_world(kLab);
  for (const sim::WorldObject& object : lab.spec.objects) {
    const Eigen::Vector2d p = object.T_map_object.translation().head<2>();
    EXPECT_TRUE((p.array() >= lab.spec.min_corner.array()).all()) << object.name;
    EXPECT_TRUE((p.array() <= lab.spec.max_corner.array()).all()) << object.name;
  }
}

}  // namespace
}  // namespace castaway::testbed
