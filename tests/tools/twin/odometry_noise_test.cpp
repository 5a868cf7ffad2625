#include "tools/twin/odometry/odometry_noise.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/tools/twin/random_drive.hpp"

namespace castaway::testbed {
namespace {

/// Stretches of 1 m and 4 m of a drive.
struct BothLengths {
  std::vector<Stretch> brief;
  std::vector<Stretch> far;

  explicit BothLengths(const std::vector<Leg>& legs)
      : brief(take_stretches(legs, 1.0)), far(take_stretches(legs, 4.0)) {}
  [[nodiscard]] OdometryNoise fit(YawWalk walk = YawWalk::kTravelAndTurn) const {
    return fit_noise({&brief, &far}, {}, {}, walk);
  }
  [[nodiscard]] YawWalk choose() const { return choose_walk({&brief, &far}, {}, fit()); }
};

void expect_sigma(double variance, double sigma, double share) {
  EXPECT_NEAR(std::sqrt(variance), sigma, share * sigma);
}

/// Mean squares of the misses of one bent way, along, across and in yaw.
struct BentWay {
  OdometryNoise noise;
  Leg leg;

  explicit BentWay(const OdometryNoise& of) : noise(of) {
    constexpr int kParts = 10;
    for (const auto& [along, turn, way] :
         {std::array{0.6, 0.4, 0.6}, std::array{0.0, 0.9, 0.18}, std::array{0.5, -0.2, 0.5},
          std::array{0.4, -0.5, 0.4}, std::array{0.7, 0.0, 0.7}}) {
      const OdometryStep part{along / kParts, 0.0, turn / kParts, way / kParts};
      leg.steps.insert(leg.steps.end(), kParts, part);
    }
    leg.way = 2.38;
    leg.rate_at_end = {0.6, -0.5};
    leg.T_start_end = correct_motion(leg.steps, {});
  }
  [[nodiscard]] Stretch stretch() const { return take_stretches({leg}, 1.0).at(0); }
  [[nodiscard]] Eigen::Vector3d mean_squares() {
    constexpr int kDraws = 20000;
    localization::Rng rng = localization::substream(1, "misses");
    boost::random::normal_distribution<double> normal;
    const auto draw = [&](double variance) { return std::sqrt(variance) * normal(rng); };
    const auto align = [&](const SE2& pose, const OdometryRate& rate) {
      const double late = draw(noise.stamp);
      const double x = draw(noise.match);
      const double y = draw(noise.match);
      return pose * SE2{late * rate.along, 0.0, late * rate.turn} *
             SE2{x, y, draw(noise.match_yaw)};
    };
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (int k = 0; k < kDraws; ++k) {
      std::vector<OdometryStep> steps = leg.steps;
      for (OdometryStep& step : steps) {
        const double by_yaw = noise.yaw_per_m * step.way + noise.yaw_per_rad * std::abs(step.turn);
        step.along += draw(noise.along_per_m * step.way);
        step.turn += draw(by_yaw);
      }
      const SE2 T_map_start = align({}, leg.rate_at_start);
      Stretch drawn = stretch();
      drawn.T_start_end = T_map_start.inverse() * align(correct_motion(steps, {}), leg.rate_at_end);
      const SE2 miss = miss_of(drawn, {});
      squares += Eigen::Vector3d(miss.x, miss.y, miss.yaw).cwiseAbs2() / kDraws;
    }
    return squares;
  }
};

/// Tolerance: 4 sigma of the draws are 4 %; the rest is where in a step its errors act, and what is
/// not linear.
void expect_variances(BentWay way) {
  const Eigen::Vector3d squares = way.mean_squares();
  const Eigen::Vector3d expected = way.noise.variances(way.stretch());
  for (int row = 0; row < 3; ++row) {
    EXPECT_NEAR(squares(row), expected(row), 0.1 * expected(row) + 1e-6) << row;
  }
}

constexpr OdometryNoise kNoNoise{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

TEST(OdometryNoise, OfWalksIsTheVarianceOfMisses) {
  OdometryNoise along = kNoNoise;
  along.along_per_m = 1e-4;
  expect_variances(BentWay(along));
  OdometryNoise by_travel = kNoNoise;
  by_travel.yaw_per_m = 1e-4;
  expect_variances(BentWay(by_travel));
  OdometryNoise by_turn = kNoNoise;
  by_turn.yaw_per_rad = 1e-4;
  expect_variances(BentWay(by_turn));
}

TEST(OdometryNoise, OfPositionsAndStampsIsTheVarianceOfMisses) {
  OdometryNoise match = kNoNoise;
  match.match = 1e-4;
  expect_variances(BentWay(match));
  OdometryNoise stamp = kNoNoise;
  stamp.stamp = 4e-4;
  BentWay way(stamp);
  way.leg.rate_at_start.along = 0.8;
  expect_variances(way);
}

// A yaw at the beginning that is wrong moves the end across.
TEST(OdometryNoise, OfYawsAtTheBeginningIsTheVarianceOfMisses) {
  OdometryNoise match = kNoNoise;
  match.match_yaw = 2.5e-5;
  expect_variances(BentWay(match));
  OdometryNoise stamp = kNoNoise;
  stamp.stamp = 4e-4;
  BentWay way(stamp);
  way.leg.rate_at_start.turn = 0.4;
  expect_variances(way);
}

TEST(OdometryNoise, SeparatesItsParts) {
  const RandomDrive drive{.legs = 20000,
                          .along = 0.02,
                          .yaw_by_travel = 0.015,
                          .yaw_by_turn = 0.02,
                          .match = 0.01,
                          .match_yaw = 0.006,
                          .stamp = 0.02};
  const OdometryNoise noise = BothLengths(legs_of(drive)).fit();
  expect_sigma(noise.along_per_m, 0.02, 0.2);
  expect_sigma(noise.yaw_per_m, 0.015, 0.2);
  expect_sigma(noise.yaw_per_rad, 0.02, 0.2);
  expect_sigma(noise.match, 0.01, 0.2);
  expect_sigma(noise.match_yaw, 0.006, 0.45);
  expect_sigma(noise.stamp, 0.02, 0.2);
}

TEST(OdometryNoise, OfAnExactDriveIsNone) {
  const OdometryNoise noise = BothLengths(legs_of({.legs = 2000})).fit();
  for (const double variance : {noise.along_per_m, noise.yaw_per_m, noise.yaw_per_rad, noise.match,
                                noise.match_yaw, noise.stamp}) {
    EXPECT_LE(variance, 1e-9);
  }
}

TEST(OdometryNoise, HasOnlyTheWalkThatIsAskedFor) {
  const BothLengths stretches(legs_of({.yaw_by_travel = 0.01, .yaw_by_turn = 0.01}));
  EXPECT_EQ(stretches.fit(YawWalk::kTravel).yaw_per_rad, 0.0);
  EXPECT_GT(stretches.fit(YawWalk::kTravel).yaw_per_m, 5e-5);
  EXPECT_EQ(stretches.fit(YawWalk::kTurn).yaw_per_m, 0.0);
  EXPECT_GT(stretches.fit(YawWalk::kTurn).yaw_per_rad, 5e-5);
}

TEST(OdometryNoise, WithstandsOutliers) {
  const RandomDrive drive{.along = 0.02, .yaw_by_travel = 0.01, .match = 0.005};
  std::vector<Leg> legs = legs_of(drive);
  for (std::size_t i = 0; i < legs.size(); i += 400) {
    legs[i].T_start_end = legs[i].T_start_end * SE2{0.3, 0.0, 0.5};
  }
  const OdometryNoise noise = BothLengths(legs).fit();
  expect_sigma(noise.along_per_m, 0.02, 0.3);
  expect_sigma(noise.yaw_per_m, 0.01, 0.3);
}

TEST(YawWalk, ByTravelIsTold) {
  for (const int number : {1, 2, 3}) {
    const RandomDrive drive{
        .yaw_by_travel = 0.015, .match = 0.01, .match_yaw = 0.005, .number = number};
    EXPECT_EQ(BothLengths(legs_of(drive)).choose(), YawWalk::kTravel) << number;
  }
}

TEST(YawWalk, ByTurnIsTold) {
  for (const int number : {1, 2, 3}) {
    const RandomDrive drive{.yaw_by_turn = 0.015, .match = 0.01, .number = number};
    EXPECT_EQ(BothLengths(legs_of(drive)).choose(), YawWalk::kTurn) << number;
  }
}

// Yaws of the alignment that are wrong move the ends of straight ways across, as a walk by travel.
TEST(YawWalk, ByTurnIsToldDespiteErrorsOfAlignedYaws) {
  for (const int number : {1, 2, 3}) {
    const RandomDrive drive{
        .yaw_by_turn = 0.015, .match = 0.01, .match_yaw = 0.005, .number = number};
    EXPECT_EQ(BothLengths(legs_of(drive)).choose(), YawWalk::kTurn) << number;
  }
}

TEST(YawWalk, ByBothIsTold) {
  for (const int number : {1, 2, 3}) {
    const RandomDrive drive{.yaw_by_travel = 0.02,
                            .yaw_by_turn = 0.02,
                            .match = 0.01,
                            .match_yaw = 0.005,
                            .number = number};
    EXPECT_EQ(BothLengths(legs_of(drive)).choose(), YawWalk::kTravelAndTurn) << number;
  }
}

}  // namespace
}  // namespace castaway::testbed
