#include "tools/scenario/world_file.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const std::string kHead = "name: w\nextent: {min: [0, 0], max: [4, 3]}\n";

WorldFile load(const TemporaryFolder& folder, const std::string& rest) {
  return load_world(folder.put("world.yaml", kHead + rest).parent_path());
}

const sim::BoxShape& box(const sim::WorldObject& object) {
  return std::get<sim::BoxShape>(object.shape);
}

TEST(WorldFile, PutsABoxOnTheFloor) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder,
           "objects:\n  - box: {at: [1, 2], size: [0.4, 0.6, 0.8], bottom: 0.1, "
           "yaw_deg: 90, color: \"#ff0080\", in_map: false}\n");
  ASSERT_EQ(world.spec.objects.size(), 1U);
  const sim::WorldObject& object = world.spec.objects[0];
  EXPECT_EQ(object.name, "box-0");
  EXPECT_EQ(box(object).size, Eigen::Vector3d(0.4, 0.6, 0.8));
  EXPECT_TRUE(object.T_map_object.translation().isApprox(Eigen::Vector3d(1.0, 2.0, 0.5)));
  const Eigen::Vector3d forward = object.T_map_object.linear() * Eigen::Vector3d::UnitX();
  EXPECT_TRUE(forward.isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(object.color.isApprox(Eigen::Vector3f(1.0F, 0.0F, 128.0F / 255.0F)));
  EXPECT_FALSE(object.in_map);
}

TEST(WorldFile, BuildsWallsWithFullCornersAndExactEnds) {
  const TemporaryFolder folder;
  const WorldFile world = load(folder,
                               "objects:\n  - wall: {name: w, points: [[0, 0], [2, 0], [2, 1]], "
                               "thickness: 0.2, height: 2}\n");
  ASSERT_EQ(world.spec.objects.size(), 2U);
  EXPECT_EQ(world.spec.objects[0].name, "w/0");
  EXPECT_TRUE(box(world.spec.objects[0]).size.isApprox(Eigen::Vector3d(2.1, 0.2, 2.0)));
  EXPECT_TRUE(
      world.spec.objects[0].T_map_object.translation().isApprox(Eigen::Vector3d(1.05, 0.0, 1.0)));
  EXPECT_TRUE(
      world.spec.objects[1].T_map_object.translation().isApprox(Eigen::Vector3d(2.0, 0.45, 1.0)));
}

TEST(WorldFile, ClosesAWall) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder, "objects:\n  - wall: {points: [[0, 0], [2, 0], [2, 1]], closed: true}\n");
  EXPECT_EQ(world.spec.objects.size(), 3U);
}

TEST(WorldFile, PutsATableOnFourLegs) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder, "objects:\n  - table: {at: [2, 1], size: [1.0, 0.6, 0.7], leg: 0.1}\n");
  ASSERT_EQ(world.spec.objects.size(), 5U);
  EXPECT_TRUE(
      world.spec.objects[0].T_map_object.translation().isApprox(Eigen::Vector3d(2.0, 1.0, 0.685)));
  EXPECT_TRUE(world.spec.objects[1].T_map_object.translation().isApprox(
      Eigen::Vector3d(1.55, 0.75, 0.335)));
}

TEST(WorldFile, FindsAMeshBesideIt) {
  const TemporaryFolder folder;
  folder.put("meshes/a.obj", "");
  const WorldFile world =
      load(folder, "objects:\n  - mesh: {at: [1, 1], file: meshes/a.obj, scale: 2}\n");
  const auto& mesh = std::get<sim::MeshShape>(world.spec.objects.at(0).shape);
  EXPECT_EQ(mesh.path, (folder.path() / "meshes/a.obj").string());
  EXPECT_EQ(mesh.scale, Eigen::Vector3d(2.0, 2.0, 2.0));
}

TEST(WorldFile, ReadsRoutesStartAndMap) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder, "start: [1, 2, 0.5]\nmap: map.yaml\nroutes: {loop: [[0, 1], [2, 3]]}\n");
  EXPECT_EQ(world.routes.at("loop").at(1), Eigen::Vector2d(2.0, 3.0));
  EXPECT_EQ(world.start.yaw, 0.5);
  EXPECT_EQ(world.map, folder.path() / "map.yaml");
  EXPECT_EQ(world.spec.max_corner, Eigen::Vector2d(4.0, 3.0));
}

TEST(WorldFile, NamesFileLineAndRemedy) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& rest) { return error_of([&] { load(folder, rest); }); };
  EXPECT_TRUE(contains(error("objects:\n  - box: {at: [1, 2], siz: [1, 1, 1]}\n"),
                       "world.yaml:4: objects[0].box: needs the key 'size'; is 'siz' meant"));
  EXPECT_TRUE(contains(error("objects:\n  - ball: {at: [1, 2]}\n"), "known are box, cylinder"));
  EXPECT_TRUE(contains(error("objects:\n  - box: {at: [1, 2], size: [1, 0, 1]}\n"), "above 0"));
  EXPECT_TRUE(contains(error("objects:\n  - box: {at: [1, 2], size: [1, 1, 1], colr: red}\n"),
                       "unknown key 'colr'; did you mean 'color'?"));
  EXPECT_TRUE(contains(error("objects:\n  - box: {at: [1, 2], size: [1, 1, 1], color: red}\n"),
                       "'red' is no colour"));
  EXPECT_TRUE(contains(error("objects:\n  - mesh: {at: [1, 2], file: no.obj}\n"), "no.obj"));
  EXPECT_TRUE(contains(error("objects:\n  - wall: {points: [[0, 0]]}\n"), "needs `points`"));
  EXPECT_TRUE(contains(error("routes: {loop: [[0, 0]]}\n"), "at least two points"));
  EXPECT_TRUE(contains(error("objects:\n  - cylinder: {name: a, at: [1, 2], radius: 1, height: 1}\n"
                             "  - cylinder: {name: a, at: [1, 2], radius: 1, height: 1}\n"),
                       "the name 'a' is taken"));
}

}  // namespace
}  // namespace castaway::testbed
