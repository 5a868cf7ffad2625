#include "tools/scenario/yaml/number_range.hpp"

#include <charconv>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

/// A scenario with every key whose value is a number.
const char* const kRich = R"(
duration_s: 2
stop_after_m: 1
start: {pose: [1, 2, 0.5], known: true, wrong_by: [0.5, 0, 0.1]}
world: {name: lab, differences: {reach_m: 2, add_boxes: 3, move_furniture: 0.5, changes: [
  {move: {name: a, by: [1, 2], turn_deg: 30}}, {open: {name: b, open_deg: 40}}]}}
lidar: {beams: 90, angle_min_deg: -90, fov_deg: 180, range_min: 0.1, range_max: 8, rate_hz: 5,
  range_sigma: 0.01, elevations_deg: [-1, 0, 1], localize_layer: 1, mount_xyz: [0, 0, 0.2],
  mount_rpy: [0, 0, 1], noise: {sigma_m: 0.01, sigma_relative: 0.01, bias_m: 0.01,
  beam_bias_sigma_m: 0.01, resolution_m: 0.01, dark_range_m: 2, dropout: 0.1, dropout_far: 0.1,
  dropout_grazing: 0.1, dropout_dark: 0.1, dust_per_m: 0.1, dust_range_m: 1, divergence_deg: 1,
  mixed_reach_m: 0.1, glass_return: 0.1, glass_angle_deg: 10}}
odometry: {ticks_per_turn: 512, radius_sigma: 0.01, track_sigma: 0.02, drift_along: 0.03,
  drift_yaw_deg: 0.4, slip: {rate_per_m: 1, length_m: 0.2, share: 0.25, collision_length_m: 0.5,
  zone_spread: 0.1}, gyro: {noise_deg: 0.5}}
events:
  - kidnap: {at_s: 1, kind: teleport, min_distance_m: 1}
  - kidnap: {at_m: 1, kind: nudge, distance_m: [1, 2]}
  - kidnap: {poisson_s: 1, times: 2, kind: turn, angle_deg: [50, 90]}
  - kidnap: {when_localized_s: 1, kind: carry, lift_m: 0.1, lift_s: 2, speed: 1, pose: [1, 2, 3]}
  - fault: {at_s: 1, for_s: 2, kind: lidar-blocked, from_deg: 1, to_deg: 2, distance_m: 1}
  - fault: {at_s: 1, for_s: 2, kind: lidar-mount, dx_m: 1, dy_m: 2, yaw_deg: 1}
  - fault: {at_s: 1, for_s: 2, kind: lidar-late, delay_s: 1}
  - fault: {at_s: 1, for_s: 2, kind: odometry-scale, scale: 1.1}
people: {count: 2, crowd: {blocked: 0.1}, groups: 0.5, standing: 1, talking: [2], at: [[1, 2, 3]]}
localizers:
  - mh_amcl
  - amcl
outputs: {video: {}, snapshots: {}, points: {every_s: 1}, camera: {}}
)";

LoadedScenario read(YamlNode root) { return read_scenario(YamlDocument(std::move(root)), "", "a"); }

bool is_number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Collects the paths of all numbers, as `put_value` takes them.
void collect(const YamlNode& node, const std::string& path, std::vector<std::string>& out) {
  const std::string prefix = path.empty() ? "" : path + ".";
  if (node.kind == YamlNode::Kind::kScalar && is_number(node.scalar)) out.push_back(path);
  for (const YamlEntry& entry : node.entries) collect(entry.value, prefix + entry.key, out);
  std::size_t index = 0;
  for (const YamlNode& item : node.items) {
    collect(item, prefix + std::to_string(index++), out);
  }
}

/// Error text for a replaced number; empty if it is accepted.
std::string refusal(YamlNode root, const std::string& path, const char* value) {
  put_value(root, path, yaml_scalar(value), "a.yaml:1");
  try {
    (void)read(std::move(root));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

class Numbers : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    root_ = parse_yaml(read(parse_yaml(kRich, "rich.yaml")).effective, "rich.yaml");
    collect(root_, "", paths_);
    std::erase(paths_, "seed");
    ASSERT_GT(paths_.size(), 120U);
  }
  YamlNode root_;
  std::vector<std::string> paths_;
};

class Nonsense : public Numbers {};
class Odd : public Numbers {};

TEST_P(Nonsense, IsRefusedWhereverAScenarioTakesANumber) {
  for (const std::string& path : paths_) {
    const std::string message = refusal(root_, path, GetParam());
    EXPECT_THAT(message, HasSubstr("a.yaml:1: ")) << path << " = " << GetParam();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(, Nonsense,
                         testing::Values("-1e308", "-1e12", "1e12", "1e300", "nan", "inf", "-inf",
                                         "1e999"));

TEST_P(Odd, IsTakenOrRefusedInOneLine) {
  std::size_t refused = 0;
  for (const std::string& path : paths_) {
    const std::string message = refusal(root_, path, GetParam());
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    refused += message.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, paths_.size() / 10) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(, Odd, testing::Values("-1", "1e-300", "1e-9", "1e9"));

TEST(NumberRange, NamesPlaceKeyAndRange) {
  YamlNode root = parse_yaml("speed: 400\n", "x.yaml");
  try {
    require_in(*root.find("speed"), "a[0].b.speed", {0.5, 100.0}, "m/s");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "x.yaml:1: a[0].b.speed: 400 is out of range; give from 0.5 to 100 m/s");
  }
}

TEST(NumberRange, HoldsForEveryNumberOfAListAndForNoText) {
  const NumberRange range{1.0, 2.0, true};
  EXPECT_NO_THROW(require_in(parse_yaml("text", "x"), "b", range, ""));
  EXPECT_NO_THROW(require_in(parse_yaml("[0, 1.5]", "x"), "b", range, ""));
  EXPECT_THROW(require_in(parse_yaml("[1.5, 3]", "x"), "b", range, ""), std::runtime_error);
  EXPECT_THROW(require_in(parse_yaml("nan", "x"), "b", range, ""), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
