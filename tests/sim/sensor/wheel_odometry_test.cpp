#include "sim/sensor/wheel_odometry.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::numbers::pi;
const DriveGeometry kDrive{0.05, 0.05, 0.4, {0.0, 0.0}};

/// Wheel angles of a drive along an arc of radius `radius` [m] by `turn` [rad].
WheelAngles arc_angles(const DriveGeometry& drive, double radius, double turn) {
  return {(radius - 0.5 * drive.track) * turn / drive.radius_left,
          (radius + 0.5 * drive.track) * turn / drive.radius_right};
}

Pose2 driven(const OdometryConfig& config, const DriveGeometry& drive, const WheelAngles& end,
             unsigned seed, int steps = 200) {
  Rng rng(seed);
  WheelOdometry odometry(config, drive, rng);
  for (int i = 1; i <= steps; ++i) {
    odometry.update({end.left * i / steps, end.right * i / steps}, rng);
  }
  return odometry.T_odom_base();
}

TEST(WheelOdometry, FollowsAnArcInClosedForm) {
  const Pose2 pose = driven(ideal_odometry(), kDrive, arc_angles(kDrive, 2.0, pi / 2), 1);
  EXPECT_NEAR(pose.x, 2.0, 1e-12);
  EXPECT_NEAR(pose.y, 2.0, 1e-12);
  EXPECT_NEAR(pose.yaw, pi / 2, 1e-12);
}

TEST(WheelOdometry, DrivesStraightAndTurnsOnTheSpot) {
  const Pose2 straight = driven(ideal_odometry(), kDrive, {20.0, 20.0}, 1);
  EXPECT_NEAR(straight.x, 1.0, 1e-12);
  EXPECT_NEAR(straight.yaw, 0.0, 1e-12);
  const Pose2 turn = driven(ideal_odometry(), kDrive, {-4.0, 4.0}, 1);
  EXPECT_NEAR(turn.x, 0.0, 1e-12);
  EXPECT_NEAR(turn.yaw, 1.0, 1e-12);
}

TEST(WheelOdometry, BaseSwingsAboutAnAxleBehindIt) {
  DriveGeometry drive = kDrive;
  drive.p_base_axle = {-0.3, 0.0};
  const Pose2 pose = driven(ideal_odometry(), drive, arc_angles(drive, 0.0, pi / 2), 1);
  EXPECT_NEAR(pose.x, -0.3, 1e-12);
  EXPECT_NEAR(pose.y, 0.3, 1e-12);
}

TEST(WheelOdometry, CountsWholeTicks) {
  OdometryConfig config = ideal_odometry();
  config.ticks_per_turn = 100;
  const double tick = 2.0 * pi / 100;
  EXPECT_DOUBLE_EQ(driven(config, kDrive, {0.9 * tick, 0.9 * tick}, 1, 1).x, 0.0);
  EXPECT_NEAR(driven(config, kDrive, {7.5 * tick, 7.5 * tick}, 1, 50).x, 7 * tick * 0.05, 1e-12);
  EXPECT_NEAR(driven(config, kDrive, {-1.5 * tick, -1.5 * tick}, 1, 50).x, -2 * tick * 0.05, 1e-12);
}

// A wheel that is believed to be larger than it is seems to roll farther.
TEST(WheelOdometry, MisjudgesEachRadiusByItsError) {
  OdometryConfig both = ideal_odometry();
  both.radius_error_left = both.radius_error_right = 0.02;
  const Pose2 straight = driven(both, kDrive, {20.0, 20.0}, 1);
  EXPECT_NEAR(straight.x, 1.02, 1e-12);
  EXPECT_NEAR(straight.yaw, 0.0, 1e-12);
  OdometryConfig left = ideal_odometry();
  left.radius_error_left = 0.02;
  EXPECT_NEAR(driven(left, kDrive, {20.0, 20.0}, 1).yaw, -0.02 / 0.4, 1e-12);
  EXPECT_NEAR(driven(left, kDrive, {20.0, 0.0}, 1).yaw, -1.02 / 0.4, 1e-12);
  EXPECT_NEAR(driven(left, kDrive, {0.0, 20.0}, 1).yaw, 1.0 / 0.4, 1e-12);
  OdometryConfig right = ideal_odometry();
  right.radius_error_right = -0.03;
  EXPECT_NEAR(driven(right, kDrive, {20.0, 20.0}, 1).yaw, -0.03 / 0.4, 1e-12);
  EXPECT_NEAR(driven(right, kDrive, {0.0, 20.0}, 1).yaw, 0.97 / 0.4, 1e-12);
  EXPECT_NEAR(driven(right, kDrive, {20.0, 0.0}, 1).yaw, -1.0 / 0.4, 1e-12);
}

// A track that is believed to be wider than it is seems to turn less.
TEST(WheelOdometry, MisjudgesTheTrackByItsError) {
  for (const double error : {0.05, -0.05}) {
    OdometryConfig config = ideal_odometry();
    config.track_error = error;
    const Pose2 turn = driven(config, kDrive, {-4.0, 4.0}, 1);
    EXPECT_NEAR(turn.yaw, 1.0 / (1.0 + error), 1e-12);
    EXPECT_NEAR(turn.x, 0.0, 1e-12);
    EXPECT_NEAR(driven(config, kDrive, {20.0, 20.0}, 1).x, 1.0, 1e-12);
  }
}

TEST(WheelOdometry, AddsFixedErrorsToThoseThatAreDrawn) {
  OdometryConfig config = ideal_odometry();
  config.radius_sigma = 0.005;
  const double drawn = driven(config, kDrive, {1.0, 1.0}, 7, 1).x / 0.05 - 1.0;
  config.radius_error_left = config.radius_error_right = 0.04;
  EXPECT_NEAR(driven(config, kDrive, {1.0, 1.0}, 7, 1).x / 0.05, 1.0 + drawn + 0.04, 1e-6);
  OdometryConfig track = ideal_odometry();
  track.track_sigma = 0.01;
  const double believed = 0.1 / driven(track, kDrive, {-1.0, 1.0}, 7, 1).yaw;
  track.track_error = 0.04;
  EXPECT_NEAR(0.1 / driven(track, kDrive, {-1.0, 1.0}, 7, 1).yaw, believed + 0.04 * 0.4, 1e-12);
}

TEST(WheelOdometry, MisjudgesRadiiByTheirSigma) {
  OdometryConfig config = ideal_odometry();
  config.radius_sigma = 0.005;
  constexpr unsigned kRobots = 4000;
  double squares = 0.0;
  for (unsigned seed = 0; seed < kRobots; ++seed) {
    const double way = driven(config, kDrive, {1.0, 1.0}, seed, 1).x;  // Mean of both radii.
    squares += std::pow(way / 0.05 - 1.0, 2);
  }
  const double expected = 0.005 / std::sqrt(2.0);
  EXPECT_NEAR(std::sqrt(squares / kRobots), expected, expected * 4.0 / std::sqrt(2.0 * kRobots));
}

TEST(WheelOdometry, MisjudgesTheTrackByItsSigma) {
  OdometryConfig config = ideal_odometry();
  config.track_sigma = 0.01;
  constexpr unsigned kRobots = 4000;
  double squares = 0.0;
  for (unsigned seed = 0; seed < kRobots; ++seed) {
    const double track = 0.1 / driven(config, kDrive, {-1.0, 1.0}, seed, 1).yaw;
    squares += std::pow(track / 0.4 - 1.0, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / kRobots), 0.01, 0.01 * 4.0 / std::sqrt(2.0 * kRobots));
}

TEST(WheelOdometry, DriftGrowsWithTheRootOfTheWay) {
  OdometryConfig config = ideal_odometry();
  config.drift_along = 0.02;
  config.drift_yaw_deg = 0.0;
  constexpr int kRuns = 3000;
  for (const double way : {1.0, 9.0}) {
    double squares = 0.0;
    for (unsigned run = 0; run < kRuns; ++run) {
      squares += std::pow(driven(config, kDrive, {way / 0.05, way / 0.05}, run, 20).x - way, 2);
    }
    const double expected = 0.02 * std::sqrt(way);
    EXPECT_NEAR(std::sqrt(squares / kRuns), expected, expected * 4.0 / std::sqrt(2.0 * kRuns));
  }
}

TEST(WheelOdometry, HeadingDriftsByItsSigma) {
  OdometryConfig config = ideal_odometry();
  config.drift_yaw_deg = 1.0;
  constexpr int kRuns = 3000;
  double squares = 0.0;
  for (unsigned run = 0; run < kRuns; ++run) {
    squares += std::pow(driven(config, kDrive, {80.0, 80.0}, run, 20).yaw, 2);  // 4 m.
  }
  const double expected = 2.0 * pi / 180.0;
  EXPECT_NEAR(std::sqrt(squares / kRuns), expected, expected * 4.0 / std::sqrt(2.0 * kRuns));
}

/// Standard deviation of the yaw over `kYawRuns` drives to the same wheel angles, about its mean.
constexpr unsigned kYawRuns = 3000;
double yaw_spread(const OdometryConfig& config, const WheelAngles& end) {
  const double exact = driven(ideal_odometry(), kDrive, end, 1, 20).yaw;
  double squares = 0.0;
  for (unsigned run = 0; run < kYawRuns; ++run) {
    squares += std::pow(driven(config, kDrive, end, run, 20).yaw - exact, 2);
  }
  return std::sqrt(squares / kYawRuns);
}

constexpr double kYawShare = 4.0 / 77.0;  // Of a standard deviation: 4 / sqrt(2 * kYawRuns).

TEST(WheelOdometry, HeadingDriftsByTurn) {
  OdometryConfig config = ideal_odometry();
  config.drift_turn_deg = 1.5;
  for (const double turn : {2.25, -2.25}) {
    const double expected = 1.5 * 1.5 * pi / 180.0;  // Times the root of the turn.
    EXPECT_NEAR(yaw_spread(config, arc_angles(kDrive, 0.0, turn)), expected, kYawShare * expected);
    const double on_arc = yaw_spread(config, arc_angles(kDrive, 2.0, turn));
    EXPECT_NEAR(on_arc, expected, kYawShare * expected);
  }
  EXPECT_EQ(driven(config, kDrive, {80.0, 80.0}, 1).yaw, 0.0);  // Straight on.
}

TEST(WheelOdometry, DriftsByTravelAndByTurnAddInQuadrature) {
  OdometryConfig config = ideal_odometry();
  config.drift_yaw_deg = 0.8;
  config.drift_turn_deg = 1.2;
  const double expected = std::hypot(0.8 * std::sqrt(4.0), 1.2 * std::sqrt(1.6)) * pi / 180.0;
  EXPECT_NEAR(yaw_spread(config, arc_angles(kDrive, 2.5, 1.6)), expected, kYawShare * expected);
}

TEST(WheelOdometry, DriftOfTheHeadingKeepsTheDistance) {
  OdometryConfig config = ideal_odometry();
  config.drift_turn_deg = 5.0;
  EXPECT_NEAR(driven(config, kDrive, {-40.0, 40.0}, 1).x, 0.0, 1e-12);
}

TEST(WheelOdometry, WithUnsignedDistancesReversingIsDrivingAhead) {
  OdometryConfig config = ideal_odometry();
  config.unsigned_distance = true;
  for (const double sign : {1.0, -1.0}) {
    const Pose2 straight = driven(config, kDrive, {20.0 * sign, 20.0 * sign}, 1);
    EXPECT_NEAR(straight.x, 1.0, 1e-12);
    EXPECT_NEAR(straight.yaw, 0.0, 1e-12);
    const Pose2 ahead = driven(config, kDrive, arc_angles(kDrive, 2.0 * sign, sign * pi / 2), 1);
    EXPECT_NEAR(ahead.x, 2.0, 1e-12);
    EXPECT_NEAR(ahead.y, 2.0 * sign, 1e-12);
    EXPECT_NEAR(ahead.yaw, sign * pi / 2, 1e-12);
    const Pose2 back = driven(config, kDrive, arc_angles(kDrive, -2.0 * sign, sign * pi / 2), 1);
    EXPECT_NEAR(back.x, 2.0, 1e-12);
    EXPECT_NEAR(back.y, 2.0 * sign, 1e-12);
    EXPECT_NEAR(back.yaw, sign * pi / 2, 1e-12);
    const Pose2 turn = driven(config, kDrive, {-4.0 * sign, 4.0 * sign}, 1);
    EXPECT_NEAR(turn.x, 0.0, 1e-12);
    EXPECT_NEAR(turn.yaw, sign, 1e-12);
  }
  EXPECT_NEAR(driven(ideal_odometry(), kDrive, {-20.0, -20.0}, 1).x, -1.0, 1e-12);
}

// The walk along the heading is not made positive.
TEST(WheelOdometry, WithUnsignedDistancesDriftsToBothSides) {
  OdometryConfig config = ideal_odometry();
  config.unsigned_distance = true;
  config.drift_along = 0.1;
  double sum = 0.0;
  constexpr unsigned kRuns = 2000;
  for (unsigned run = 0; run < kRuns; ++run) {
    sum += driven(config, kDrive, {-20.0, -20.0}, run, 20).x - 1.0;
  }
  EXPECT_NEAR(sum / kRuns, 0.0, 4.0 * 0.1 / std::sqrt(kRuns));
}

TEST(WheelOdometry, StandingStillDoesNotDrift) {
  OdometryConfig config;
  config.drift_turn_deg = 1.0;
  const Pose2 pose = driven(config, kDrive, {0.0, 0.0}, 3);
  EXPECT_EQ(pose.x, 0.0);
  EXPECT_EQ(pose.yaw, 0.0);
}

TEST(OdometryConfig, RefusesWhatCannotBe) {
  OdometryConfig config;
  config.track_sigma = -0.1;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

TEST(OdometryConfig, RefusesANegativeDriftByTurnAndNamesIt) {
  OdometryConfig config;
  config.drift_turn_deg = -0.25;
  try {
    validate(config);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("drift_turn_deg is -0.25"), std::string::npos);
  }
  config.drift_turn_deg = std::nan("");
  EXPECT_THROW(validate(config), std::invalid_argument);
  config.drift_turn_deg = 0.0;
  EXPECT_NO_THROW(validate(config));
}

TEST(OdometryConfig, RefusesFixedErrorsThatCannotBeAndNamesThem) {
  const auto refusal = [](double OdometryConfig::*field, double value) -> std::string {
    OdometryConfig config;
    config.*field = value;
    try {
      validate(config);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const std::vector<std::pair<std::string, double OdometryConfig::*>> fields = {
      {"radius_error_left", &OdometryConfig::radius_error_left},
      {"radius_error_right", &OdometryConfig::radius_error_right},
      {"track_error", &OdometryConfig::track_error}};
  for (const auto& [name, field] : fields) {
    for (const double value : {0.51, -0.51, std::nan("")}) {
      EXPECT_NE(refusal(field, value).find(name + " is "), std::string::npos) << name << value;
    }
    EXPECT_NE(refusal(field, 0.51).find("0.51"), std::string::npos);
    for (const double value : {0.5, -0.5, 0.0}) EXPECT_EQ(refusal(field, value), "") << name;
  }
}

}  // namespace
}  // namespace castaway::sim
