#include "sim/casting/surfaces.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

WorldSpec shop() {
  WorldSpec world;
  world.objects = {box_on_floor("shelf", {1.0, 1.0, 1.0}, {2.0, 0.0}),
                   box_on_floor("pane", {0.1, 1.0, 1.0}, {4.0, 0.0}),
                   box_on_floor("parcel", {0.2, 0.2, 0.2}, {0.0, 3.0})};
  world.objects[0].surface.reflectivity = 0.25;
  world.objects[1].surface.glass = true;
  world.objects[2].in_map = false;
  return world;
}

TEST(Surfaces, AreThoseOfTheObjects) {
  const Surfaces surfaces(shop());
  EXPECT_EQ(surfaces.of(0).reflectivity, 0.25);
  EXPECT_TRUE(surfaces.of(1).glass);
  EXPECT_EQ(surfaces.of(99).reflectivity, Surface{}.reflectivity);
}

TEST(Surfaces, PeopleAndFloorHaveTheirOwn) {
  const Surfaces surfaces(shop());
  EXPECT_NE(surfaces.of(kHitPerson + 4).reflectivity, Surface{}.reflectivity);
  EXPECT_NE(surfaces.of(kHitFloor).reflectivity, Surface{}.reflectivity);
  EXPECT_FALSE(surfaces.of(kHitPerson).glass);
}

TEST(HitName, SaysWhatABeamMet) {
  const WorldSpec world = shop();
  EXPECT_EQ(hit_name(world, 0), "object shelf");
  EXPECT_EQ(hit_name(world, 1), "glass pane");
  EXPECT_EQ(hit_name(world, 2), "unmapped parcel");
  EXPECT_EQ(hit_name(world, kHitPerson + 3), "person 3");
  EXPECT_EQ(hit_name(world, kHitFloor), "floor");
  EXPECT_EQ(hit_name(world, kHitDust), "dust");
  EXPECT_EQ(hit_name(world, kHitCover), "cover");
  EXPECT_EQ(hit_name(world, kHitNothing), "nothing");
}

}  // namespace
}  // namespace castaway::sim
