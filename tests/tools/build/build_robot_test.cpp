#include "tools/build/build_robot.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(BuildRobot, FindsShippedRobotsInEitherLanguage) {
  EXPECT_EQ(build_robot({"waffle", {}, {}, {}}, ".").name, "waffle");
  EXPECT_EQ(build_robot({"butler", {}, {}, {}}, ".").name, "butler");
  EXPECT_THROW((void)build_robot({"r2d2", {}, {}, {}}, "."), std::runtime_error);
}

TEST(BuildRobot, PassesArgumentsOn) {
  const double low = build_robot({"mule", {{"mast", "false"}}, {}, {}}, ".").height;
  EXPECT_LT(low, build_robot({"mule", {}, {}, {}}, ".").height);
}

TEST(BuildRobot, ReadsYamlAsXacroDoes) {
  const auto file = std::filesystem::path(testing::TempDir()) / "build_robot.yaml";
  std::ofstream(file) << "a: {b: [1, 0.5, text]}\nc: true\nd: ~\n";
  const xacro::Value value = robot_options({}, ".").read_yaml(file.string());
  EXPECT_EQ(to_text(value), "{'a': {'b': [1, 0.5, 'text']}, 'c': True, 'd': None}");
  EXPECT_THROW((void)robot_options({}, ".").read_yaml("/nowhere.yaml"), std::runtime_error);
  std::ofstream(file) << "angle: !degrees 90\n";
  EXPECT_THROW((void)robot_options({}, ".").read_yaml(file.string()), std::runtime_error);
}

TEST(BuildRobot, SearchesFromTheScenariosFolder) {
  const auto base = std::filesystem::path(testing::TempDir()) / "build_robot_base";
  std::filesystem::create_directories(base / "packages");
  const RobotSpec spec{"waffle", {}, {"packages", "/elsewhere"}, {}};
  const std::vector<std::string> paths = robot_options(spec, base).search_paths;
  EXPECT_EQ(paths, (std::vector<std::string>{(base / "packages").string(), "/elsewhere"}));
}

}  // namespace
}  // namespace castaway::testbed
