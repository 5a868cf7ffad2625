#include "tools/play/observation/observation_scene.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

/// A robot of one item in the middle of an empty map of 10 m x 10 m, with its lidar at 0.5 m; two
/// beams end on it, one 4 m ahead.
Observation seen_on_empty_map() {
  localization::OccupancyGrid grid;
  grid.frame = {100, 100, 0.1, {-5.0, -5.0, 0.0}};
  grid.cells.assign(grid.frame.size(), localization::CellState::kFree);
  localization::DistanceField distances(grid, 1.0);
  Observation seen;
  seen.planar = CostMap{std::move(grid), std::move(distances)};
  seen.T_base_laser.translation().z() = 0.5;
  const Vector3f lidar(0.0F, 0.0F, 0.5F);
  seen.beams = {{lidar, {1.0F, 1.0F, 0.5F}, 1.0F},
                {lidar, {-1.5F, 0.0F, 0.5F}, 0.1F},
                {lidar, {4.0F, 0.0F, 0.5F}, 1.0F}};
  seen.robot.emplace_back();
  return seen;
}

TEST(ObservationScene, BeamsEndWhereTheyEndOrAtTheEdge) {
  const Observation seen = seen_on_empty_map();
  const sim::Scene scene = observation_scene(seen, {2.0, 1.6F});
  constexpr std::size_t kAxes = 6;
  ASSERT_EQ(scene.lines.size(), kAxes + seen.beams.size() + 1U);
  const auto end = [&](std::size_t beam) { return scene.lines[kAxes + beam].points.at(1); };
  EXPECT_EQ(end(0), seen.beams[0].end);
  EXPECT_EQ(end(1), seen.beams[1].end);
  EXPECT_TRUE(end(2).isApprox(Vector3f(2.0F, 0.0F, 0.5F)));
  // Lines down to the map from the ends in view.
  const auto& down = scene.lines.back().points;
  ASSERT_EQ(down.size(), 4U);
  EXPECT_TRUE(down[1].isApprox(Vector3f(1.0F, 1.0F, 0.0F)));
  // The map, the robot, and a ball for each end in view.
  ASSERT_EQ(scene.items.size(), 4U);
  const Vector3f ball = scene.items[2].T_map_mesh.translation();
  const Vector3f from_eye = (seen.beams[0].end - scene.camera.eye).normalized();
  EXPECT_TRUE((ball - scene.camera.eye).normalized().isApprox(from_eye, 1e-5F));
  EXPECT_GT(scene.items[2].color.y(), scene.items[2].color.x());  // Green,
  EXPECT_GT(scene.items[3].color.x(), scene.items[3].color.y());  // red.
}

TEST(ObservationScene, LooksFromTheSouthOrAlongTheContourLines) {
  Observation seen = seen_on_empty_map();
  const ObservationView view{2.0, 1.6F};
  const auto to_eye = [&] {
    const sim::Camera camera = observation_scene(seen, view).camera;
    return Vector3f(camera.eye - camera.target).normalized();
  };
  EXPECT_NEAR(to_eye().x(), 0.0F, 1e-4F);
  EXPECT_LT(to_eye().y(), -0.5F);
  // Uphill is north-east: the fall line is seen from the south-east.
  seen.T_map_base.linear() =
      Eigen::AngleAxisd(0.2, Eigen::Vector3d(1.0, -1.0, 0.0).normalized()).toRotationMatrix();
  EXPECT_NEAR(to_eye().x(), -to_eye().y(), 1e-4F);
  EXPECT_GT(to_eye().x(), 0.3F);
}

TEST(ObservationScene, PeopleOutsideOfTheWindowAreLeftOut) {
  Observation seen = seen_on_empty_map();
  seen.people.resize(2);
  seen.people[0].T_map_mesh.translation() = Vector3f(1.0F, 1.0F, 0.9F);
  seen.people[1].T_map_mesh.translation() = Vector3f(3.0F, 1.0F, 0.9F);
  EXPECT_EQ(observation_scene(seen, {2.0, 1.6F}).items.size(), 4U + 1U);
}

}  // namespace
}  // namespace castaway::testbed
