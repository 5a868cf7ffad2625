#include "tools/scenario/world/world_file.hpp"

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

TEST(WorldFile, HangsADoorBetweenTwoPosts) {
  const TemporaryFolder folder;
  const WorldFile world = load(folder,
                               "objects:\n  - door: {name: d, at: [2, 1], width: 1, yaw_deg: 90, "
                               "hinge: right, open_deg: 90, in_map: closed}\n");
  ASSERT_EQ(world.spec.objects.size(), 4U);
  EXPECT_EQ(world.spec.objects[0].name, "d/post-left");
  EXPECT_TRUE(
      world.spec.objects[0].T_map_object.translation().isApprox(Eigen::Vector3d(2.0, 0.475, 1.0)));
  const sim::WorldObject& leaf = world.spec.objects[2];
  EXPECT_EQ(leaf.name, "d/leaf");  // From the hinge at (2, 1.495) towards -x.
  EXPECT_TRUE(leaf.T_map_object.translation().isApprox(Eigen::Vector3d(1.505, 1.495, 1.0), 1e-9));
  EXPECT_FALSE(leaf.in_map);
  const sim::WorldObject& mapped = world.spec.objects[3];
  EXPECT_TRUE(mapped.T_map_object.translation().isApprox(Eigen::Vector3d(2.0, 1.0, 1.0), 1e-9));
  EXPECT_TRUE(mapped.in_map);
  EXPECT_FALSE(mapped.in_world);
  ASSERT_EQ(world.spec.doors.size(), 1U);
  EXPECT_EQ(world.spec.doors[0].name, "d");
}

TEST(WorldFile, PutsGlassIntoWindowsAndPanes) {
  const TemporaryFolder folder;
  const WorldFile world = load(folder,
                               "objects:\n  - window: {from: [0, 1], to: [2, 1], sill: 0.8}\n"
                               "  - glass: {points: [[1, 1], [3, 1]], reflectivity: 0.1}\n"
                               "  - box: {at: [1, 1], size: [1, 1, 1], glass: true}\n");
  ASSERT_EQ(world.spec.objects.size(), 4U);
  EXPECT_FALSE(world.spec.objects[0].surface.glass);
  EXPECT_TRUE(box(world.spec.objects[0]).size.isApprox(Eigen::Vector3d(2.0, 0.1, 0.8)));
  EXPECT_TRUE(world.spec.objects[1].surface.glass);
  EXPECT_TRUE(box(world.spec.objects[1]).size.isApprox(Eigen::Vector3d(2.0, 0.02, 1.6)));
  EXPECT_TRUE(world.spec.objects[2].surface.glass);
  EXPECT_EQ(world.spec.objects[2].surface.reflectivity, 0.1);
  EXPECT_TRUE(world.spec.objects[3].surface.glass);
}

TEST(WorldFile, KnowsRampsStepsAndBalls) {
  const TemporaryFolder folder;
  const WorldFile world = load(folder,
                               "objects:\n  - ramp: {at: [1, 1], size: [2, 1, 0.2]}\n"
                               "  - step: {at: [2, 1], size: [1, 1, 0.02]}\n"
                               "  - sphere: {at: [3, 1], radius: 0.3}\n");
  EXPECT_TRUE(world.spec.objects[0].drivable);
  EXPECT_TRUE(std::holds_alternative<sim::RampShape>(world.spec.objects[0].shape));
  EXPECT_TRUE(world.spec.objects[1].drivable);
  EXPECT_FALSE(world.spec.objects[2].drivable);
  EXPECT_EQ(world.spec.objects[2].T_map_object.translation().z(), 0.3);
  EXPECT_TRUE(world.spec.objects[2].movable);
}

TEST(WorldFile, BuildsFurnitureOfBoxes) {
  const TemporaryFolder folder;
  const WorldFile world = load(folder,
                               "objects:\n  - chair: {name: c, at: [1, 1]}\n"
                               "  - shelf: {name: s, at: [2, 1], size: [2, 1, 1.8], levels: 2}\n");
  ASSERT_EQ(world.spec.objects.size(), 12U);  // Seat, legs, back; posts, boards.
  EXPECT_EQ(world.spec.objects[0].piece, "c");
  EXPECT_NEAR(world.spec.objects[5].T_map_object.translation().x(), 1.0 - 0.2075, 1e-12);
  EXPECT_EQ(world.spec.objects[11].piece, "s");
  EXPECT_NEAR(world.spec.objects[11].T_map_object.translation().z(), 1.785, 1e-12);
}

TEST(WorldFile, RepeatsAGroupInRows) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder,
           "objects:\n  - repeat:\n      name: r\n      count: [2, 3]\n      spacing: [1, 0.5]\n"
           "      at: [1, 0]\n      yaw_deg: 90\n      objects:\n"
           "        - box: {name: b, at: [0.2, 0], size: [0.1, 0.1, 1]}\n"
           "        - door: {name: d, at: [0, 0.2], width: 0.3}\n");
  ASSERT_EQ(world.spec.objects.size(), 24U);
  EXPECT_EQ(world.spec.objects[0].name, "r/0-0/b");
  EXPECT_EQ(world.spec.objects[0].piece, "r/0-0/b");
  EXPECT_EQ(world.spec.objects[4].name, "r/1-0/b");
  EXPECT_TRUE(world.spec.objects[4].T_map_object.translation().isApprox(
      Eigen::Vector3d(1.0, 1.2, 0.5), 1e-9));
  EXPECT_TRUE(world.spec.objects[8].T_map_object.translation().isApprox(
      Eigen::Vector3d(0.5, 0.2, 0.5), 1e-9));
  ASSERT_EQ(world.spec.doors.size(), 6U);
  EXPECT_EQ(world.spec.doors[5].name, "r/1-2/d");
}

TEST(WorldFile, TellsWhatIsOnlyOnTheMapFromWhatIsOnlyInTheWorld) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder,
           "objects:\n  - box: {at: [1, 1], size: [1, 1, 1], in_map: false}\n"
           "  - box: {at: [2, 1], size: [1, 1, 1], in_world: false, movable: false}\n");
  EXPECT_TRUE(world.spec.objects[0].in_world);
  EXPECT_FALSE(world.spec.objects[0].in_map);
  EXPECT_FALSE(world.spec.objects[1].in_world);
  EXPECT_FALSE(world.spec.objects[1].movable);
}

TEST(WorldFile, ReadsSlipZones) {
  const TemporaryFolder folder;
  const WorldFile world =
      load(folder, "slip_zones:\n  - {name: rug, outline: [[0, 0], [1, 0], [1, 1]], slip: 0.3}\n");
  ASSERT_EQ(world.spec.slip_zones.size(), 1U);
  EXPECT_EQ(world.spec.slip_zones[0].name, "rug");
  EXPECT_EQ(world.spec.slip_zones[0].slip, 0.3);
  EXPECT_EQ(world.spec.slip_zones[0].outline.size(), 3U);
}

TEST(WorldFile, NamesFileLineAndRemedy) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& rest) { return error_of([&] { load(folder, rest); }); };
  EXPECT_TRUE(contains(error("objects:\n  - box: {at: [1, 2], siz: [1, 1, 1]}\n"),
                       "world.yaml:4: objects[0].box: needs the key 'size'; is 'siz' meant"));
  EXPECT_TRUE(contains(error("objects:\n  - ball: {at: [1, 2]}\n"), "known are box, chair"));
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
