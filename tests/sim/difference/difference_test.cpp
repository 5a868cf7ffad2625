#include "sim/difference/difference.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/difference/changed_beams.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/world/door.hpp"
#include "sim/world/footprint.hpp"
#include "sim/world/furniture.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

/// The test room with movable table and shelf, a lamp on the table, and ten stools.
WorldSpec furnished_room() {
  WorldSpec world = test_room();
  for (WorldObject& object : world.objects) {
    object.movable = object.name == "table" || object.name == "shelf";
  }
  WorldObject lamp = box_on_floor("lamp", {0.2, 0.2, 0.3}, {0.4, 0.2});
  lamp.T_map_object.translation().z() = 0.85;
  lamp.movable = true;
  world.objects.push_back(lamp);
  for (int i = 0; i < 10; ++i) {
    world.objects.push_back(
        box_on_floor("stool-" + std::to_string(i), {0.3, 0.3, 0.4}, {-3.5 + 0.7 * i, -2.6}));
    world.objects.back().movable = true;
  }
  return world;
}

const KeepClear kKeep{{{{-3.0, 2.0}, {2.5, 2.0}, {2.5, -1.5}, {-3.0, -1.5}}},
                      Eigen::Vector2d(-3.0, 0.0)};

ChangedWorld changed(const DifferenceSpec& spec, std::uint64_t seed) {
  const WorldSpec world = furnished_room();
  Rng rng(seed);
  return change_world(world, spec, rasterise(world, 0.2, 0.05), kKeep, rng);
}

int standing(const WorldSpec& world) {
  return static_cast<int>(std::count_if(world.objects.begin(), world.objects.end(),
                                        [](const auto& object) { return object.in_world; }));
}

TEST(Difference, GroupsWhatOverlapsFromAbove) {
  const auto groups = furniture_groups(furnished_room());
  ASSERT_EQ(groups.size(), 12U);  // Table with lamp, shelf, ten stools.
  EXPECT_EQ(groups[0].objects.size(), 2U);
}

TEST(Difference, NothingChangesNothing) {
  EXPECT_TRUE(DifferenceSpec{}.empty());
  const ChangedWorld result = changed({}, 1);
  EXPECT_EQ(result.world.objects.size(), furnished_room().objects.size());
  EXPECT_EQ(changed_beams(result.world, rasterise(result.world, 0.2, 0.05), {0.2}).share, 0.0);
}

class RandomDifferences : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomDifferences, KeepTheirDistanceAndTheMap) {
  DifferenceSpec spec;
  spec.move_furniture = 0.6;
  spec.remove = 0.2;
  spec.add_boxes = 4;
  const ChangedWorld result = changed(spec, GetParam());
  EXPECT_GT(result.moved + result.removed, 2);
  EXPECT_EQ(rasterise(result.world, 0.2, 0.05).cells, rasterise(furnished_room(), 0.2, 0.05).cells);
  const auto& objects = result.world.objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].in_world || objects[i].in_map) continue;  // Moved or added.
    const ConvexOutline outline = footprint(objects[i]);
    EXPECT_GE(distance(outline, *kKeep.start), 0.6) << objects[i].name;
    for (double t = 0.0; t <= 1.0; t += 0.01) {
      EXPECT_GE(distance(outline, {-3.0 + 5.5 * t, 2.0}), 0.44) << objects[i].name;
      EXPECT_GE(distance(outline, {2.5, 2.0 - 3.5 * t}), 0.44) << objects[i].name;
    }
    for (std::size_t j = 0; j < objects.size(); ++j) {
      const bool lamp = objects[i].name == "lamp" || objects[j].name == "lamp";
      if (i == j || !objects[j].in_world || lamp) continue;
      EXPECT_FALSE(overlap(outline, footprint(objects[j])))
          << objects[i].name << " in " << objects[j].name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomDifferences, testing::Range<std::uint64_t>(1, 21));

TEST(Difference, SameSeedSameWorld) {
  DifferenceSpec spec;
  spec.move_furniture = 0.5;
  spec.add_boxes = 3;
  const WorldSpec a = changed(spec, 5).world;
  const WorldSpec b = changed(spec, 5).world;
  const WorldSpec c = changed(spec, 6).world;
  ASSERT_EQ(a.objects.size(), b.objects.size());
  bool differs = a.objects.size() != c.objects.size();
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].T_map_object.matrix(), b.objects[i].T_map_object.matrix());
    differs = differs || i >= c.objects.size() ||
              a.objects[i].T_map_object.matrix() != c.objects[i].T_map_object.matrix();
  }
  EXPECT_TRUE(differs);
}

TEST(Difference, AllMayBeRemoved) {
  DifferenceSpec spec;
  spec.remove = 1.0;
  const ChangedWorld result = changed(spec, 1);
  EXPECT_EQ(result.removed, 12);
  EXPECT_EQ(standing(result.world), 5);  // Walls and the pillar.
}

TEST(Difference, CarriesOutChangesByName) {
  DifferenceSpec spec;
  spec.changes = {{Change::Kind::kMove, "shelf", {-1.0, 0.5}, 90.0},
                  {Change::Kind::kRemove, "table"}};
  spec.changes.push_back({Change::Kind::kAdd});
  spec.changes.back().objects = {box_on_floor("crate", {0.5, 0.5, 0.5}, {-3.5, 1.0})};
  const ChangedWorld result = changed(spec, 1);
  EXPECT_EQ(result.moved, 1);
  EXPECT_EQ(result.removed, 1);
  EXPECT_EQ(result.added, 1);
  const auto named = [&](const std::string& name) {
    return *std::find_if(result.world.objects.begin(), result.world.objects.end(),
                         [&](const auto& object) { return object.name == name; });
  };
  EXPECT_TRUE(named("shelf").T_map_object.translation().isApprox(Eigen::Vector3d(2.7, 1.5, 0.9)));
  EXPECT_FALSE(named("table").in_world);
  EXPECT_FALSE(named("crate").in_map);
}

TEST(Difference, UnknownNamesAndSharesAreErrors) {
  DifferenceSpec spec;
  spec.changes = {{Change::Kind::kMove, "sofa"}};
  EXPECT_THROW(changed(spec, 1), std::invalid_argument);
  spec = {};
  spec.remove = 1.5;
  EXPECT_THROW(changed(spec, 1), std::invalid_argument);
  spec = {};
  spec.add_boxes = -1;
  EXPECT_THROW(changed(spec, 1), std::invalid_argument);
}

TEST(Difference, DoorsCloseButNotAcrossARoute) {
  WorldSpec world = furnished_room();
  Door door;
  door.name = "a";
  door.T_map_hinge = Eigen::Translation3d(-0.5, 2.0, 0.0);  // On the route.
  door.open_deg = 90.0;
  world.doors = {door, door};
  world.doors[1].name = "b";
  world.doors[1].T_map_hinge = Eigen::Translation3d(-1.6, -0.6, 0.0);
  for (const Door& d : world.doors) world.objects.push_back(door_leaf(d, 90.0));
  DifferenceSpec spec;
  spec.close_doors = 1.0;
  Rng rng(1);
  const Grid map = rasterise(world, 0.2, 0.05);
  const ChangedWorld result = change_world(world, spec, map, kKeep, rng);
  EXPECT_EQ(result.closed, 1);
  EXPECT_EQ(result.world.doors[0].open_deg, 90.0);
  EXPECT_EQ(result.world.doors[1].open_deg, 0.0);
  EXPECT_EQ(result.notes.size(), 1U);
}

/// A wall of a square room stands 1 m further inside than on the map: exactly the beams that hit it
/// are shorter.
TEST(ChangedBeams, CountsTheBeamsOnAWallThatMoved) {
  WorldSpec world;
  world.min_corner = {-5.1, -5.1};
  world.max_corner = {5.1, 5.1};
  world.objects = {box_on_floor("south", {10.2, 0.1, 1.0}, {0.0, -5.05}),
                   box_on_floor("north", {10.2, 0.1, 1.0}, {0.0, 5.05}),
                   box_on_floor("west", {0.1, 10.0, 1.0}, {-5.05, 0.0}),
                   box_on_floor("east", {0.1, 10.0, 1.0}, {5.05, 0.0}),
                   box_on_floor("screen", {0.1, 10.0, 1.0}, {4.05, 0.0})};
  world.objects[4].in_map = false;
  const Grid map = rasterise(world, 0.2, 0.05);
  const BeamChange change = changed_beams(world, map, {0.2, 20.0, 360});
  EXPECT_GT(change.places, 250);
  // Seen from a place, the angle of the screen is that of the wall behind it through a frame: on
  // average a quarter over the square, less in the remaining part, so between a fifth and a third.
  EXPECT_GT(change.share, 0.2);
  EXPECT_LT(change.share, 0.34);
  EXPECT_NEAR(change.share, change.share_fine, 0.005);  // Except for grazing beams.
}

}  // namespace
}  // namespace castaway::sim
