#include "sim/events/world_change.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

WorldChange of(double at_s, std::variant<PutObject, TakeObject, TurnDoor, AddPeople> what) {
  return {at_s, std::move(what)};
}

TEST(WorldChange, KeepsTheIndicesOfObjects) {
  const WorldSpec before = test_room();
  const PutObject crate{box_on_floor("crate", {1.0, 1.0, 1.0}, {0.0, 0.0})};
  PutObject other = crate;
  other.object.name = "other";
  const WorldSpec after =
      world_after(before, {of(3.0, TakeObject{"crate"}), of(2.0, other), of(1.0, crate)});
  ASSERT_EQ(after.objects.size(), before.objects.size() + 2);
  EXPECT_EQ(after.objects[before.objects.size()].name, "crate");
  EXPECT_FALSE(after.objects[before.objects.size()].in_world);
  EXPECT_EQ(after.objects.back().name, "other");
  EXPECT_TRUE(after.objects.back().in_world);
  EXPECT_FALSE(after.objects.back().in_map);
}

TEST(WorldChange, RefusesNamesThatAreTakenOrUnknown) {
  const PutObject crate{box_on_floor("crate", {1.0, 1.0, 1.0}, {0.0, 0.0})};
  const auto refuses = [](const std::vector<WorldChange>& changes) {
    EXPECT_THROW(world_after(test_room(), changes), std::invalid_argument);
  };
  refuses({of(1.0, crate), of(2.0, crate)});
  refuses({of(1.0, crate), of(2.0, TakeObject{"crate"}), of(3.0, crate)});
  refuses({of(2.0, crate), of(1.0, TakeObject{"crate"})});
  refuses({of(1.0, TakeObject{"table"})});
  refuses({of(1.0, TurnDoor{"door", 10.0})});
  refuses({of(-1.0, crate)});
}

TEST(WorldChange, ChecksItsValues) {
  EXPECT_THROW(validate(of(0.0, TurnDoor{"door", 181.0})), std::invalid_argument);
  EXPECT_THROW(validate(of(0.0, AddPeople{{}, 5, true})), std::invalid_argument);
  EXPECT_THROW(validate(of(0.0, AddPeople{{}, 0})), std::invalid_argument);
  EXPECT_NO_THROW(validate(of(0.0, AddPeople{{}, 6})));
}

TEST(WorldChange, HasTheNameOfWhatItIsAbout) {
  EXPECT_EQ(name_of(of(0.0, TakeObject{"crate"})), "crate");
  EXPECT_EQ(name_of(of(0.0, AddPeople{})), "");
}

TEST(WorldChange, TellsOfItself) {
  WorldSpec world = test_room();
  world.doors.push_back({.name = "D1"});
  const WorldNews put =
      news_of(of(0.0, PutObject{box_on_floor("crate", {1.0, 1.0, 0.8}, {0.0, 0.0})}), world);
  EXPECT_EQ(put.what, WorldNews::What(WorldNews::Put{"crate"}));
  EXPECT_EQ(put.outline.size(), 4U);
  EXPECT_EQ(put.z, Eigen::Vector2d(0.0, 0.8));
  const WorldNews door = news_of(of(0.0, TurnDoor{"D1", 45.0}), world);
  EXPECT_EQ(door.what, WorldNews::What(WorldNews::Door{"D1", 45.0}));
  EXPECT_FALSE(door.outline.empty());
  const WorldNews take = news_of(of(0.0, TakeObject{"crate"}), world);
  EXPECT_EQ(take.what, WorldNews::What(WorldNews::Take{"crate"}));
  EXPECT_TRUE(take.outline.empty());
  const WorldNews people = news_of(of(0.0, AddPeople{{}, 3, true}), world);
  EXPECT_EQ(people.what, WorldNews::What(WorldNews::People{3}));
}

}  // namespace
}  // namespace castaway::sim
