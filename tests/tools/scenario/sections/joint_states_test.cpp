#include "tools/scenario/sections/joint_states.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const char* const kMessage =
    "header:\n  stamp: {sec: 1, nanosec: 2}\n  frame_id: ''\nname: [lift, elbow]\n"
    "position: [0.1, -1.5]\nvelocity: []\neffort: []\n---\n";

TEST(JointStates, AreReadAsRosPrintsThem) {
  const TemporaryFolder folder;
  const auto joints = read_joint_states(folder.put("j.yaml", kMessage));
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_EQ(joints.at("lift"), 0.1);
  EXPECT_EQ(joints.at("elbow"), -1.5);
}

TEST(JointStates, AreReadFromAScenarioByValueOrByFile) {
  const TemporaryFolder folder;
  folder.put("j.yaml", kMessage);
  YamlDocument by_value = YamlDocument::parse("joints: {elbow: 0.5}", "s.yaml");
  YamlReader value = by_value.root();
  EXPECT_EQ(read_joints(value, folder.path()).at("elbow"), 0.5);
  YamlDocument by_file = YamlDocument::parse("joints: j.yaml", "s.yaml");
  YamlReader file = by_file.root();
  EXPECT_EQ(read_joints(file, folder.path()).at("elbow"), -1.5);
  YamlDocument none = YamlDocument::parse("file: waffle", "s.yaml");
  YamlReader without = none.root();
  EXPECT_TRUE(read_joints(without, folder.path()).empty());
}

TEST(JointStates, OfUnequalLengthsAreRefused) {
  const TemporaryFolder folder;
  const auto path = folder.put("j.yaml", "name: [a, b]\nposition: [1]\n");
  EXPECT_TRUE(contains(error_of([&] { read_joint_states(path); }), "j.yaml:2"));
}

}  // namespace
}  // namespace castaway::testbed
