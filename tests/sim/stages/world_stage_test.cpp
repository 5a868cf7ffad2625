#include "sim/stages/world_stage.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

WorldChange crate_at(double at_s, const std::string& name) {
  return {at_s, PutObject{box_on_floor(name, {0.4, 0.4, 0.8}, {0.0, 0.0})}};
}

TEST(WorldStage, ChangesTakePlaceInOrderOfTime) {
  const WorldSpec room = test_room();
  WorldStage stage(room, {crate_at(2.0, "b"), crate_at(1.0, "a")});
  stage.add(crate_at(1.5, "between"), room);
  std::vector<std::string> made;
  const auto make = [&](const WorldChange& change) {
    made.push_back(name_of(change));
    return true;
  };
  EXPECT_FALSE(stage.due(milliseconds(999)));
  EXPECT_TRUE(stage.due(seconds(1)));
  stage.advance(milliseconds(1600), make);
  EXPECT_EQ(made, (std::vector<std::string>{"a", "between"}));
  stage.advance(seconds(2), make);
  EXPECT_EQ(made.back(), "b");
  EXPECT_FALSE(stage.due(seconds(99)));
}

TEST(WorldStage, OneThatHasNoRoomHoldsUpThoseBehindIt) {
  WorldStage stage(test_room(), {crate_at(1.0, "a"), crate_at(1.0, "b")});
  int tries = 0;
  stage.advance(seconds(1), [&](const WorldChange&) { return ++tries > 1; });
  EXPECT_EQ(tries, 1);
  EXPECT_FALSE(stage.due(milliseconds(1040)));
  EXPECT_TRUE(stage.due(milliseconds(1050)));
  stage.advance(milliseconds(1050), [&](const WorldChange&) { return ++tries > 1; });
  EXPECT_EQ(tries, 3);
}

TEST(IsClear, OfRobotAndPeopleByTheirRoom) {
  const WorldObject crate = box_on_floor("crate", {0.4, 0.4, 0.8}, {0.0, 0.0});
  const auto clear = [&](double robot_x, const std::vector<Eigen::Vector2d>& people) {
    return is_clear(crate, {{robot_x, 0.0}, 0.25, people}, 0.05);
  };
  EXPECT_TRUE(clear(0.56, {}));  // 0.2 + 0.25 + 0.1 m.
  EXPECT_FALSE(clear(0.54, {}));
  EXPECT_FALSE(clear(0.0, {}));
  EXPECT_TRUE(clear(3.0, {{0.0, 0.56}}));
  EXPECT_FALSE(clear(3.0, {{5.0, 5.0}, {0.0, 0.54}}));
}

}  // namespace
}  // namespace castaway::sim
