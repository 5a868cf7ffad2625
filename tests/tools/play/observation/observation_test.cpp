#include "tools/play/observation/observation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/play/observation/observation_colors.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

/// A room of 6 m x 4 m. The map of the localizer lacks the crate.
constexpr const char* kRoom = R"(name: room
extent: {min: [-0.5, -0.5], max: [6.5, 4.5]}
start: [2, 2, 0.4]
objects:
  - wall: {points: [[0, 0], [6, 0], [6, 4], [0, 4]], closed: true, thickness: 0.1, height: 2}
  - box: {name: crate, at: [4, 2], size: [0.5, 0.5, 1], in_map: false}
)";

/// A hall with a ramp of 15 %, on which the robot starts.
constexpr const char* kRamp = R"(name: ramp
extent: {min: [0, 0], max: [20, 8]}
start: [7, 3, 0]
levels: true
objects:
  - wall: {points: [[0.1, 0.1], [19.9, 0.1], [19.9, 7.9], [0.1, 7.9]], closed: true, height: 4}
  - box: {name: platform, at: [15.5, 3], size: [6, 5, 0.2], bottom: 1.3, drivable: true}
  - ramp: {name: up, at: [7.5, 3], size: [10, 2, 1.5]}
)";

class Observe : public testing::Test {
 protected:
  Observation observe_in(const char* world, double time_s = 0.0) {
    folder_.put("w.yaml", world);
    scenario_.world.file = "w.yaml";
    scenario_.robot.file = "disc";
    scenario_.duration_s = 20.0;
    scenario_.lidars.front().profile = "ideal";
    scenario_.lidars.front().set("range_max", 12.0);
    return observe(scenario_, folder_.path(), time_s);
  }

  TemporaryFolder folder_;
  Scenario scenario_;
};

/// Distance from the inner faces of the room's walls.
float from_walls(const Vector3f& p) {
  return std::min(std::min(std::abs(p.x() - 0.05F), std::abs(p.x() - 5.95F)),
                  std::min(std::abs(p.y() - 0.05F), std::abs(p.y() - 3.95F)));
}

TEST_F(Observe, BeamsEndWhereTheScanEndsAndFitTheMapThere) {
  const Observation seen = observe_in(kRoom);
  ASSERT_TRUE(seen.planar);
  EXPECT_FALSE(seen.volume);
  ASSERT_EQ(seen.beams.size(), 90U);
  const Vector3f lidar = (seen.T_map_base * seen.T_base_laser).translation().cast<float>();
  int on_crate = 0;
  for (const ObservedBeam& beam : seen.beams) {
    EXPECT_LT((beam.origin - lidar).norm(), 1e-4F);
    EXPECT_NEAR(beam.end.z(), lidar.z(), 0.01F);
    if (from_walls(beam.end) < 0.02F) {
      EXPECT_GT(beam.likelihood, 0.8F);
      continue;
    }
    ++on_crate;
    EXPECT_NEAR(beam.end.x(), 3.75F, 0.02F);
    EXPECT_NEAR(beam.likelihood, endpoint_likelihood(seen.model, 5.0), 1e-3F);
  }
  EXPECT_GE(on_crate, 4);
}

TEST_F(Observe, WithoutATimeTheRobotStandsAtItsStart) {
  const Observation seen = observe_in(kRoom);
  EXPECT_NEAR(seen.T_map_base.translation().x(), 2.0, 0.005);
  EXPECT_NEAR(seen.T_map_base.translation().y(), 2.0, 0.005);
  EXPECT_NEAR(seen.T_map_base.translation().z(), 0.0, 0.005);
}

TEST_F(Observe, OnARampTheRobotIsTiltedAndTheBeamsFitIn3d) {
  const Observation seen = observe_in(kRamp);
  ASSERT_TRUE(seen.volume);
  EXPECT_FALSE(seen.planar);
  const Vector3f ahead = seen.T_map_base.linear().col(0).cast<float>();
  EXPECT_NEAR(ahead.z() / ahead.x(), 0.15F, 0.01F);
  EXPECT_NEAR(seen.T_map_base.translation().z(), 0.675, 0.02);  // 4.5 m up a ramp of 15 %.
  ASSERT_GT(seen.beams.size(), 50U);
  double sum = 0.0;
  for (const ObservedBeam& beam : seen.beams) sum += static_cast<double>(beam.likelihood);
  EXPECT_GT(sum / static_cast<double>(seen.beams.size()), 0.9);
}

TEST_F(Observe, ATimeAfterTheRunOrAfterItsLastScanIsRefused) {
  const auto refusal = [&](double time_s) -> std::string {
    try {
      observe_in(kRoom, time_s);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(30.0), "there is no scan at 30 s: the run ends at 20 s");
  EXPECT_EQ(refusal(19.99), "no lidar sees anything from 19.99 s to the end of the run at 20 s");
}

}  // namespace
}  // namespace castaway::testbed
