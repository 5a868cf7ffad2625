#include "tools/pages/campaign/figures/paired_figures.hpp"

#include <gtest/gtest.h>

#include "localization/geometry/random.hpp"
#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

PairedCell cell_of(std::size_t series, const std::vector<std::optional<double>>& times,
                   std::optional<double> tracking = std::nullopt, std::uint64_t seed = 1) {
  PairedCell cell{series, seed, {}, tracking};
  for (std::size_t i = 0; i < times.size(); ++i) {
    cell.kidnaps.push_back({kidnap_of("x", 5.0 + static_cast<double>(i), times[i]),
                            static_cast<int>(i), times[i].value_or(10.0)});
  }
  return cell;
}

TEST(PairedFigures, CompareTheKidnapsOfACell) {
  LocalizerPairs pairs(2);
  pairs.add({cell_of(0, {1.0, std::nullopt}, 0.1), cell_of(1, {3.0, 2.0}, 0.3)});
  const PairedFigures& pair = pairs.pairs().at(0);
  EXPECT_EQ(pair.recoveries.both, 1);
  EXPECT_EQ(pair.recoveries.only_second, 1);
  EXPECT_EQ(pair.recovery_time_s.mean().mean(), -2.0);
  EXPECT_EQ(pair.time_lost_s.mean().count(), 2);
  EXPECT_EQ(pair.time_lost_s.mean().mean(), 0.5 * (-2.0 + 8.0));
  EXPECT_DOUBLE_EQ(pair.tracking_error_m.mean().mean(), -0.2);
}

TEST(PairedFigures, LeavesOutWhatIsNoPair) {
  LocalizerPairs pairs(2);
  PairedCell later = cell_of(1, {1.0});
  later.kidnaps[0].kidnap.at_s += 0.5;
  pairs.add({cell_of(0, {1.0}), later});
  pairs.add({cell_of(0, {1.0}, 0.2)});
  EXPECT_EQ(pairs.pairs()[0].recoveries.trials(), 0);
  EXPECT_EQ(pairs.pairs()[0].tracking_error_m.mean().count(), 0);
  EXPECT_TRUE(paired_tests(pairs).empty());
}

TEST(PairedFigures, OfThreeLocalizersAreThreePairs) {
  EXPECT_EQ(LocalizerPairs(3).pairs().size(), 3U);
  EXPECT_TRUE(LocalizerPairs(1).pairs().empty());
  EXPECT_TRUE(LocalizerPairs(0).pairs().empty());
}

TEST(PairedFigures, CorrectsForTheNumberOfTests) {
  LocalizerPairs pairs(2);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    pairs.add({cell_of(0, {1.0}, {}, seed), cell_of(1, {std::nullopt}, {}, seed)});
  }
  const std::vector<PairedTest> tests = paired_tests(pairs);
  ASSERT_EQ(tests.size(), 3U);  // Nobody recovered in a pair, and no tracking error is known.
  EXPECT_EQ(tests[0].figure, "recovered");
  EXPECT_EQ(tests[0].counts, "6 to 0");
  EXPECT_EQ(tests[0].seeds, 6);
  EXPECT_DOUBLE_EQ(tests[0].p_value, 2.0 / 64.0);
  EXPECT_DOUBLE_EQ(tests[0].corrected, 6.0 / 64.0);
  EXPECT_DOUBLE_EQ(tests[1].p_value, 2.0 / 64.0);
  EXPECT_EQ(tests[2].difference, -9.0);
  EXPECT_DOUBLE_EQ(tests[2].p_value, 2.0 / 64.0);
}

// Four cells of each of three seeds: McNemar's test has twelve coins, the sign-flip test three.
TEST(PairedFigures, TakeTheCellsOfASeedTogether) {
  LocalizerPairs pairs(2);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (int cell = 0; cell < 4; ++cell) {
      pairs.add({cell_of(0, {1.0}, 0.1, seed), cell_of(1, {std::nullopt}, 0.2, seed)});
    }
  }
  const std::vector<PairedTest> tests = paired_tests(pairs);
  ASSERT_EQ(tests.size(), 4U);
  EXPECT_DOUBLE_EQ(tests[0].p_value, 2.0 / 4096.0);
  EXPECT_EQ(tests[1].figure, "recovered, by seed");
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(tests[i].pairs, 12);
    EXPECT_EQ(tests[i].seeds, 3);
    EXPECT_DOUBLE_EQ(tests[i].p_value, 2.0 / 8.0) << tests[i].figure;
  }
}

// Both tests of one mean agree for many seeds: the sign-flip test is estimated from 20000 flips, a
// standard deviation below 0.004.
TEST(PairedFigures, BeyondTheLimitTheTestChangesAndTheResultDoesNot) {
  localization::Rng rng = localization::substream(1, "pairs");
  PairedMean below;
  PairedMean beyond;
  for (std::uint64_t seed = 0; seed < 2001; ++seed) {
    const double value = static_cast<double>(rng() >> 11U) / static_cast<double>(1ULL << 53U);
    if (seed < 2000) below.add(value - 0.487, seed);
    beyond.add(value - 0.487, seed);
  }
  EXPECT_NEAR(below.p_value("test"), below.mean().p_value(), 4 * 0.004);
  EXPECT_EQ(beyond.p_value("test"), beyond.mean().p_value());
}

}  // namespace
}  // namespace castaway::testbed
