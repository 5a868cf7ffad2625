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

TEST(WorldChange, SaysWhatItIs) {
  EXPECT_EQ(to_string(of(0.0, TurnDoor{"D1", 0.0})), "D1 closed");
  EXPECT_EQ(to_string(of(0.0, TurnDoor{"D1", 45.0})), "D1 open by 45 deg");
  EXPECT_EQ(to_string(of(0.0, AddPeople{{}, 3, true})), "3 people came");
  EXPECT_EQ(name_of(of(0.0, TakeObject{"crate"})), "crate");
  EXPECT_EQ(name_of(of(0.0, AddPeople{})), "");
}

}  // namespace
}  // namespace castaway::sim
