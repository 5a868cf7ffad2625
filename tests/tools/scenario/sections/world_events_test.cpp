#include "tools/scenario/sections/world_events.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

sim::WorldChange change_of(const std::string& name, const std::string& body) {
  YamlDocument document = YamlDocument::parse(name + ": " + body, "scenario.yaml");
  YamlReader root = document.root();
  const sim::WorldChange change = read_world_change(name, root.child(name), "given");
  document.reject_unknown_keys();
  return change;
}

TEST(WorldEvents, ABoxStandsOnTheFloor) {
  const sim::WorldChange change = change_of(
      "box", "{at_s: 3, at: [1, 2], yaw_deg: 90, size: [0.6, 0.4, 1.0], reflectivity: 0.1}");
  EXPECT_EQ(change.at_s, 3.0);
  const sim::WorldObject& box = std::get<sim::PutObject>(change.what).object;
  EXPECT_EQ(box.name, "given");
  EXPECT_EQ(std::get<sim::BoxShape>(box.shape).size, Eigen::Vector3d(0.6, 0.4, 1.0));
  EXPECT_TRUE(box.T_map_object.translation().isApprox(Eigen::Vector3d(1.0, 2.0, 0.5)));
  EXPECT_TRUE(box.T_map_object.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_EQ(box.surface.reflectivity, 0.1);
  EXPECT_FALSE(box.in_map);
}

TEST(WorldEvents, ReadTheOtherKinds) {
  const auto cylinder = std::get<sim::PutObject>(
      change_of("cylinder", "{at_s: 0, at: [0, 0], radius: 0.2, height: 2, name: post}").what);
  EXPECT_EQ(cylinder.object.name, "post");
  EXPECT_EQ(std::get<sim::CylinderShape>(cylinder.object.shape).radius, 0.2);
  const auto door =
      std::get<sim::TurnDoor>(change_of("door", "{at_s: 0, name: D, open_deg: -30}").what);
  EXPECT_EQ(door.name, "D");
  EXPECT_EQ(door.open_deg, -30.0);
  EXPECT_EQ(std::get<sim::TakeObject>(change_of("remove", "{at_s: 0, name: post}").what).name,
            "post");
  const auto people = std::get<sim::AddPeople>(
      change_of("people", "{at_s: 0, at: [1, 1], count: 3, walk: true, behaviour: mixed}").what);
  EXPECT_EQ(people.count, 3);
  EXPECT_TRUE(people.walk);
  EXPECT_FALSE(people.behaviour);
}

TEST(WorldEvents, RefuseWhatIsMissingOrWrong) {
  const std::vector<std::vector<std::string>> wrong = {
      {"box", "{at_s: 1}", "at"},
      {"box", "{at: [1, 2]}", "at_s"},
      {"box", "{at_s: 1, at: [1, 2], size: [1, 1, 0]}", "size"},
      {"box", "{at_s: 1, at: [1, 2], colour: red}", "colour"},
      {"door", "{at_s: 1, name: D}", "open_deg"},
      {"door", "{at_s: 1, name: D, open_deg: 270}", "open_deg"},
      {"remove", "{at_s: 1}", "name"},
      {"people", "{at_s: 1, at: [0, 0], count: 7}", "count"},
      {"people", "{at_s: 1, at: [0, 0], behaviour: shy}", "shy"}};
  for (const auto& each : wrong) {
    EXPECT_TRUE(contains(error_of([&] { (void)change_of(each[0], each[1]); }), each[2])) << each[1];
  }
}

}  // namespace
}  // namespace castaway::testbed
