#include "tools/scenario/sections/lidar_yaml.hpp"

#include <map>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

std::vector<LidarSpec> read_lidar_list(const std::string& text) {
  YamlDocument document = YamlDocument::parse(text, "scenario.yaml");
  YamlReader root = document.root();
  std::vector<LidarSpec> lidars = read_lidars(root);
  document.reject_unknown_keys();
  return lidars;
}

sim::LidarConfig lidar_with(const std::string& settings) {
  return apply_changes({}, read_lidar_list("lidar: {" + settings + "}").back().changes);
}

TEST(LidarSpec, WithoutKeysChangesNothing) {
  const sim::LidarConfig lidar = lidar_with("");
  EXPECT_EQ(lidar.beams, sim::LidarConfig{}.beams);
  EXPECT_EQ(lidar.angle_increment, sim::LidarConfig{}.angle_increment);
  EXPECT_EQ(lidar.noise.sigma, sim::LidarConfig{}.noise.sigma);
}

TEST(LidarSpec, AFieldOfViewLiesAhead) {
  const sim::LidarConfig lidar = lidar_with("beams: 541, fov_deg: 270");
  EXPECT_NEAR(lidar.angle_min, -135.0 * kRadians, 1e-12);
  EXPECT_NEAR(lidar.angle_increment, 0.5 * kRadians, 1e-12);
}

TEST(LidarSpec, AFullCircleDoesNotRepeatItsFirstBeam) {
  const sim::LidarConfig lidar = lidar_with("beams: 400, fov_deg: 360, angle_min_deg: 0");
  EXPECT_EQ(lidar.angle_min, 0.0);
  EXPECT_NEAR(lidar.angle_increment, 0.9 * kRadians, 1e-12);
}

TEST(LidarSpec, FewerBeamsKeepTheField) {
  EXPECT_NEAR(lidar_with("beams: 90").angle_increment, 4.0 * kRadians, 1e-12);
}

std::map<std::string, std::string> lidar_described(sim::LidarConfig lidar) {
  std::vector<SettingText> texts;
  fields(Settings::describing(texts, ""), lidar);
  std::map<std::string, std::string> values;
  for (const SettingText& text : texts) values[text.path] = text.value;
  return values;
}

TEST(LidarSpec, ReadsEveryKeyOfItsNoise) {
  int noises = 0;
  for (const auto& [key, value] : lidar_described({})) {
    if (!key.starts_with("noise.") || key == "noise.glass") continue;
    const sim::LidarConfig lidar = lidar_with("noise: {" + key.substr(6) + ": 0.4321}");
    EXPECT_EQ(lidar_described(lidar)[key], "0.4321") << key;
    ++noises;
  }
  EXPECT_EQ(noises, 16);
  EXPECT_EQ(lidar_with("noise: {sigma_m: 0.02}").noise.sigma, 0.02);
  EXPECT_EQ(lidar_with("noise: {mixed_reach_m: 0.3}").light.mixed_reach, 0.3);
  EXPECT_TRUE(lidar_with("noise: {glass: true}").light.glass);
  EXPECT_EQ(lidar_with("range_sigma: 0.03").noise.sigma, 0.03);
}

TEST(LidarSpec, ReadsTheErrorOfStamps) {
  EXPECT_EQ(lidar_with("stamp_sigma_s: 0.03").stamp_sigma, 0.03);
  EXPECT_EQ(lidar_with("").stamp_sigma, 0.0);
  EXPECT_THROW((void)lidar_with("stamp_sigma_s: -0.01"), std::runtime_error);
  EXPECT_THROW((void)lidar_with("stamp_sigma_s: 10.5"), std::runtime_error);
}

TEST(LidarSpec, ReadsLayersAndIntensity) {
  const sim::LidarConfig lidar =
      lidar_with("elevations_deg: [-1, 0.5, 2], localize_layer: 2, intensity: reflectivity");
  ASSERT_EQ(lidar.elevations.size(), 3U);
  EXPECT_NEAR(lidar.elevations[0], -kRadians, 1e-12);
  EXPECT_EQ(lidar.planar_layer, 2);
  EXPECT_EQ(lidar.intensity, sim::Intensity::kReflectivity);
}

TEST(LidarSpec, SeveralHaveNamesAndProfiles) {
  const auto lidars = read_lidar_list(
      "lidars: [front, {rear: {profile: tim571, mount_xyz: [-0.3, 0, 0.2], rate_hz: 5}}]");
  ASSERT_EQ(lidars.size(), 2U);
  EXPECT_EQ(lidars[0].name, "front");
  EXPECT_EQ(lidars[0].profile, "robot");
  EXPECT_EQ(lidars[1].profile, "tim571");
  EXPECT_EQ(lidars[1].name, "rear");
  EXPECT_EQ(apply_changes({}, lidars[1].changes).T_base_laser.translation().x(), -0.3);
}

TEST(LidarSpec, NamesAFileOfScanTimes) {
  EXPECT_EQ(read_lidar_list("lidar: {scan_times: times.txt}").at(0).scan_times, "times.txt");
  EXPECT_EQ(read_lidar_list("lidar: {beams: 90}").at(0).scan_times, "");
  const auto lidars = read_lidar_list("lidars: [front, {rear: {scan_times: times.txt}}]");
  EXPECT_EQ(lidars.at(0).scan_times, "");
  EXPECT_EQ(lidars.at(1).scan_times, "times.txt");
}

TEST(LidarSpec, SaysWhatIsWrong) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      (void)read_lidar_list(text);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of("lidar: {noise: {sigma: 0.1}}"), testing::HasSubstr("sigma_m"));
  EXPECT_THAT(error_of("lidar: {beams: 0}"), testing::HasSubstr("1 to 100000"));
  EXPECT_THAT(error_of("lidar: {intensity: bright}"), testing::HasSubstr("none, power"));
  EXPECT_THAT(error_of("lidars: [a, a]"), testing::HasSubstr("two lidars are named 'a'"));
}

}  // namespace
}  // namespace castaway::testbed
