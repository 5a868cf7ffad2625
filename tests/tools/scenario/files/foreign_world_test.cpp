#include "tools/scenario/files/foreign_world.hpp"

#include <string>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

std::string format_of(const std::string& head) { return foreign_format(head).value_or(""); }

TEST(ForeignWorld, IsKnownByItsFirstBytes) {
  EXPECT_EQ(format_of("#VRML_SIM R2023b utf8\nWorldInfo {\n}\n"), "a world of Webots");
  EXPECT_EQ(format_of("#usda 1.0\n(\n)\n"), "a USD stage, as of Isaac Sim");
  EXPECT_EQ(format_of(std::string("PXR-USDC\0\7", 10)), "a USD stage, as of Isaac Sim");
}

TEST(ForeignWorld, IsKnownByItsRoot) {
  EXPECT_EQ(format_of("<mujoco model=\"m\"><worldbody/></mujoco>"), "a model of MuJoCo");
  EXPECT_EQ(format_of("<?xml version=\"1.0\"?>\n<!-- a <b> -->\n<mvsim_world version=\"1.0\">"),
            "a world of MVSim");
  EXPECT_EQ(format_of("\xEF\xBB\xBF<mujoco>"), "a model of MuJoCo");
}

TEST(ForeignWorld, IsKnownByItsWords) {
  EXPECT_EQ(format_of("# a cave\ninclude \"pioneer.inc\"\nresolution 0.02\n"
                      "define block model ( size [1 1 1] )\n"),
            "a world of Stage");
  EXPECT_EQ(format_of("window\n(\n  size [ 600 700 ]\n)\n"), "a world of Stage");
  EXPECT_EQ(format_of("name: building\nlevels:\n  L1:\n    vertices:\n      - [1, 2, 0, \"\"]\n"),
            "a building of RMF's traffic editor");
}

TEST(ForeignWorld, IsNoneOfOurs) {
  EXPECT_EQ(format_of("<?xml version=\"1.0\"?><sdf version=\"1.6\"><world name=\"w\">"), "");
  EXPECT_EQ(format_of("image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"), "");
  EXPECT_EQ(format_of("name: flat\nextent: {min: [0, 0], max: [8, 6]}\nlevels: true\nobjects:\n"
                      "  - window: {from: [2, 6], to: [4, 6]}\n"),
            "");
  EXPECT_EQ(format_of(""), "");
}

}  // namespace
}  // namespace castaway::testbed
