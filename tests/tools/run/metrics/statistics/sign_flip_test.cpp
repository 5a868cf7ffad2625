#include "tools/run/metrics/statistics/sign_flip.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

TEST(SignFlipTest, CountsFlipsByHand) {
  // Sums of +-1 +-2 +-3: 6, 0, 2, -4, 4, -2, 0, -6. Two of eight are as far from 0 as 6.
  EXPECT_DOUBLE_EQ(sign_flip_p_value({1.0, 2.0, 3.0}, "a"), 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(sign_flip_p_value({-1.0, 2.0, 3.0}, "a"), 4.0 / 8.0);
  EXPECT_DOUBLE_EQ(sign_flip_p_value({0.2, 0.2, 0.2, 0.2, 0.2}, "a"), 2.0 / 32.0);
}

TEST(SignFlipTest, SeesNothingInNothing) {
  EXPECT_DOUBLE_EQ(sign_flip_p_value({}, "a"), 1.0);
  EXPECT_DOUBLE_EQ(sign_flip_p_value({0.0, 0.0}, "a"), 1.0);
  EXPECT_DOUBLE_EQ(sign_flip_p_value(std::vector<double>(100, 0.0), "a"), 1.0);
}

TEST(SignFlipTest, SamplesWhatIsTooMuchToCount) {
  std::vector<double> differences(17, 0.0);
  differences[0] = 1.0;
  differences[1] = 2.0;
  differences[2] = 3.0;
  const double sigma = std::sqrt(0.25 * 0.75 / 20000.0);
  EXPECT_NEAR(sign_flip_p_value(differences, "a"), 2.0 / 8.0, 4.0 * sigma);
  EXPECT_EQ(sign_flip_p_value(differences, "a"), sign_flip_p_value(differences, "a"));
  EXPECT_GT(sign_flip_p_value(std::vector<double>(1000, 1.0), "a"), 0.0);
}

// Under the null hypothesis, one in twenty p-values is below 0.05.
TEST(SignFlipTest, HoldsItsLevel) {
  localization::Rng rng = localization::substream(1, "differences");
  boost::random::normal_distribution<double> normal;
  int below = 0;
  constexpr int kTrials = 2000;
  for (int i = 0; i < kTrials; ++i) {
    std::vector<double> differences(10);
    for (double& difference : differences) difference = normal(rng);
    below += sign_flip_p_value(differences, "a") < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(below, 0.05 * kTrials, 4.0 * std::sqrt(0.05 * 0.95 * kTrials));
}

TEST(Holm, MultipliesByHowManyAreLeft) {
  const std::vector<double> corrected = holm({0.04, 0.01, 0.03, 0.5});
  EXPECT_DOUBLE_EQ(corrected[1], 0.04);
  EXPECT_DOUBLE_EQ(corrected[2], 0.09);
  EXPECT_DOUBLE_EQ(corrected[0], 0.09);  // never below the corrected value of a smaller one
  EXPECT_DOUBLE_EQ(corrected[3], 0.5);
  EXPECT_DOUBLE_EQ(holm({0.9, 0.8})[0], 1.0);
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace castaway::testbed
