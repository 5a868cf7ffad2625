#include "sim/common/random.hpp"

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::sim {
namespace {

TEST(Draws, AreTheDistributionsOfBoost) {
  Rng rng(3);
  Rng same(3);
  for (int i = 0; i < 100; ++i) {
    boost::random::uniform_real_distribution<double> uniform(-2.0, 5.0);
    EXPECT_EQ(draw_between(-2.0, 5.0, rng), uniform(same));
    boost::random::normal_distribution<double> normal;
    EXPECT_EQ(draw_normal(rng), normal(same));
  }
}

TEST(Draws, BetweenTwoNumbersAreUniform) {
  Rng rng(4);
  constexpr int kDraws = 10000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = draw_between(2.0, 4.0, rng);
    EXPECT_GE(x, 2.0);
    EXPECT_LT(x, 4.0);
    sum += x;
  }
  EXPECT_NEAR(sum / kDraws, 3.0, 0.03);  // 5 sigma: 5 * 2 / sqrt(12 * 10000)
}

}  // namespace
}  // namespace castaway::sim
