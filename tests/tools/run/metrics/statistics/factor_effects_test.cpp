#include "tools/run/metrics/statistics/factor_effects.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;

/// Outcomes of 3 x 2 combinations: f(a, b) and noise of a seed, which all combinations share, and
/// of each cell.
template <typename Function>
FactorialOutcomes factorial(int seeds, double shared, double own, const Function& f) {
  FactorialOutcomes outcomes{{3, 2}, std::vector<std::vector<double>>(6)};
  Rng rng = localization::substream(1, "factorial");
  boost::random::normal_distribution<double> normal;
  for (int s = 0; s < seeds; ++s) {
    const double of_seed = shared * normal(rng);
    for (int c = 0; c < 6; ++c) {
      const double value = f(c / 2, c % 2) + of_seed + own * normal(rng);
      outcomes.values[static_cast<std::size_t>(c)].push_back(value);
    }
  }
  return outcomes;
}

TEST(FactorialEffects, OfASumAreTheVariancesOfItsTerms) {
  // Variances: 6 of a, 1 of b, none of the seed.
  const auto effects =
      factorial_effects(factorial(4, 0.0, 0.0, [](int a, int b) { return 3.0 * a + 2.0 * b; }));
  ASSERT_EQ(effects.size(), 3U);
  EXPECT_NEAR(effects[0].first, 6.0 / 7.0, 1e-12);
  EXPECT_NEAR(effects[0].total, 6.0 / 7.0, 1e-12);
  EXPECT_NEAR(effects[1].first, 1.0 / 7.0, 1e-12);
  EXPECT_NEAR(effects[1].total, 1.0 / 7.0, 1e-12);
  EXPECT_NEAR(effects[2].total, 0.0, 1e-12);
  EXPECT_NEAR(effects[0].first_interval.low, 6.0 / 7.0, 1e-12);
}

TEST(FactorialEffects, OfAnInteractionAreInAllOnly) {
  // (a - 1) (2 b - 1): neither has an effect alone.
  const auto effects = factorial_effects(
      factorial(4, 0.0, 0.0, [](int a, int b) { return (a - 1.0) * (2.0 * b - 1.0); }));
  EXPECT_NEAR(effects[0].first, 0.0, 1e-12);
  EXPECT_NEAR(effects[0].total, 1.0, 1e-12);
  EXPECT_NEAR(effects[1].first, 0.0, 1e-12);
  EXPECT_NEAR(effects[1].total, 1.0, 1e-12);
}

TEST(FactorialEffects, TellChanceFromTheKeys) {
  // Variances: 6 of a, 1 of b, 4 shared by a seed, 9 of each cell.
  const auto effects =
      factorial_effects(factorial(2000, 2.0, 3.0, [](int a, int b) { return 3.0 * a + 2.0 * b; }));
  EXPECT_NEAR(effects[0].first, 6.0 / 20.0, 0.02);
  EXPECT_NEAR(effects[1].first, 1.0 / 20.0, 0.01);
  EXPECT_NEAR(effects[2].total, 13.0 / 20.0, 0.03);
  EXPECT_LT(effects[0].first_interval.low, 6.0 / 20.0);
  EXPECT_GT(effects[0].first_interval.high, 6.0 / 20.0);
}

TEST(FactorialEffects, OfKeysThatDoNothingAreNone) {
  const auto effects = factorial_effects(factorial(300, 0.0, 1.0, [](int, int) { return 0.0; }));
  EXPECT_LT(effects[0].first, 0.01);
  EXPECT_LT(effects[1].first, 0.01);
}

TEST(FactorialEffects, NeedSeedsAndVariance) {
  const auto sum = [](int a, int b) { return 1.0 * a + b; };
  EXPECT_TRUE(factorial_effects(factorial(1, 0.0, 0.0, sum)).empty());
  EXPECT_TRUE(factorial_effects(factorial(5, 0.0, 0.0, [](int, int) { return 2.0; })).empty());
  EXPECT_TRUE(factorial_effects({{2}, {}}).empty());
}

/// T. Ishigami and T. Homma's function (1990), whose indices are known.
double ishigami(const double (&x)[3]) {
  return std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2.0) +
         0.1 * std::pow(x[2], 4.0) * std::sin(x[0]);
}

SwappedOutcomes swapped_ishigami(int count) {
  SwappedOutcomes outcomes;
  outcomes.swapped.resize(3);
  Rng rng = localization::substream(1, "ishigami");
  boost::random::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (int i = 0; i < count; ++i) {
    double a[3], b[3];
    for (double& x : a) x = angle(rng);
    for (double& x : b) x = angle(rng);
    outcomes.first.push_back(ishigami(a));
    outcomes.second.push_back(ishigami(b));
    for (std::size_t k = 0; k < 3; ++k) {
      const double kept = a[k];
      a[k] = b[k];
      outcomes.swapped[k].push_back(ishigami(a));
      a[k] = kept;
    }
  }
  return outcomes;
}

TEST(SwappedEffects, OfIshigamisFunctionAreThosePublished) {
  const auto effects = swapped_effects(swapped_ishigami(20000));
  ASSERT_EQ(effects.size(), 3U);
  const double first[] = {0.3139, 0.4424, 0.0};
  const double total[] = {0.5576, 0.4424, 0.2437};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(effects[k].first, first[k], 0.03) << k;
    EXPECT_NEAR(effects[k].total, total[k], 0.03) << k;
    EXPECT_LT(effects[k].first_interval.low, first[k] + 0.01);
    EXPECT_GT(effects[k].first_interval.high, first[k] - 0.01);
  }
}

TEST(SwappedEffects, NeedValuesAndVariance) {
  EXPECT_TRUE(swapped_effects({{1.0}, {2.0}, {{1.5}}}).empty());
  EXPECT_TRUE(swapped_effects({{1.0, 1.0}, {1.0, 1.0}, {{1.0, 1.0}}}).empty());
}

}  // namespace
}  // namespace castaway::testbed
