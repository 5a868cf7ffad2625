#include "localization/sensor/likelihood_field.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// One wall cell, number 5 of 10.
LikelihoodField wall_field() { return {{}, test::string_map({".....#...."}, 0.1)}; }

TEST(LikelihoodField, WeighsByTheSumOfCubes) {
  const SE2 pose{0.05, 0.05, 0.0};
  // At the wall: pz = 0.5 + 0.5 / 10 = 0.55, cubed 0.166375. Two cells in front of it, d = 0.2 =
  // sigma: pz = 0.5 * exp(-0.5) + 0.05 = 0.353265, cubed 0.044086.
  EXPECT_NEAR(wall_field().beam_probability(0.0, 10.0), 0.55, 1e-12);
  EXPECT_NEAR(wall_field().beam_probability(0.2, 10.0), 0.353265, 1e-6);
  EXPECT_NEAR(wall_field().weight(test::forward_beams({0.5F}), pose, 10.0), 1.166375, 1e-6);
  EXPECT_NEAR(wall_field().weight(test::forward_beams({0.5F, 0.3F}), pose, 10.0), 1.210461, 1e-6);
}

TEST(LikelihoodField, CapsDistancesOffTheMap) {
  const double far = 0.5 * std::exp(-0.5 * 100.0) + 0.05;
  EXPECT_NEAR(wall_field().weight(test::forward_beams({0.5F}), {50.0, 0.0, 0.0}, 10.0),
              1.0 + far * far * far, 1e-9);
}

TEST(LikelihoodField, QualityIsTheMeanOfTheHits) {
  const SE2 pose{0.05, 0.05, 0.0};
  EXPECT_NEAR(wall_field().quality(test::forward_beams({0.5F, 0.3F}), pose),
              (1.0 + std::exp(-0.5)) / 2.0, 1e-6);
  EXPECT_EQ(wall_field().quality({}, pose), 0.0);
}

}  // namespace
}  // namespace castaway::localization
