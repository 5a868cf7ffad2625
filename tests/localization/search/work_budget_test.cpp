#include "localization/search/work_budget.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

constexpr std::int64_t kAll = std::int64_t{1} << 40;

TEST(WorkBudget, GrantsAtMostWhatOneScanMayCost) {
  const WorkBudget budget({1.0, 50.0}, 10.0);
  EXPECT_EQ(budget.grant(kAll), 140000);  // 0.35 of 50 ms; the rest weighs the places found.
  EXPECT_EQ(budget.grant(300), 300);
}

TEST(WorkBudget, LimitsAllSearchesOfAScanTogether) {
  WorkBudget budget({1.0, 50.0}, 10.0);
  budget.spend(100000);
  EXPECT_EQ(budget.grant(kAll), 40000);
  budget.spend(70000);
  EXPECT_EQ(budget.grant(kAll), 0);
  budget.earn(from_seconds(1.0));
  EXPECT_EQ(budget.grant(kAll), 140000);
}

TEST(WorkBudget, LeavesPlacesToTheNextScanWhereASearchHasSpentTooMuch) {
  WorkBudget budget({1.0, 50.0}, 10.0);
  EXPECT_TRUE(budget.affords(kAll));  // They cannot be divided.
  budget.spend(140000);
  EXPECT_TRUE(budget.affords(120000));  // 0.65 of 50 ms together.
  EXPECT_FALSE(budget.affords(120001));
  budget.earn(from_seconds(1.0));
  EXPECT_TRUE(budget.affords(kAll));
}

TEST(WorkBudget, GrantsLessOnLargeMaps) {
  EXPECT_EQ(tiles_per_ms(0), 8000.0);
  EXPECT_EQ(tiles_per_ms(2000000), 4000.0);
  WorkBudget budget({1.0, 50.0}, 10.0, 2000000);
  EXPECT_EQ(budget.grant(kAll), 70000);
  budget.spend(70000);
  EXPECT_TRUE(budget.affords(60000));
  EXPECT_FALSE(budget.affords(60001));
}

TEST(WorkBudget, SavesTheEarningsOfAMinute) {
  WorkBudget budget({1.0, 50.0}, 10.0);
  budget.spend(600 * 4800 - 1000);  // 1 ms less 0.4 ms for tracking, for 600 scans.
  budget.earn(from_seconds(1.0));
  EXPECT_EQ(budget.grant(kAll), 1000 + 4800);
  budget.earn(from_seconds(1.02));
  EXPECT_EQ(budget.grant(kAll), 1000 + 2 * 4800);
  budget.earn(from_seconds(1.52));
  EXPECT_EQ(budget.grant(kAll), 1000 + 7 * 4800);
  budget.earn(from_seconds(1000.0));
  budget.spend(599 * 4800);
  budget.earn(from_seconds(1000.1));
  EXPECT_EQ(budget.grant(kAll), 2 * 4800);
}

TEST(WorkBudget, GrantsALittleEvenInDebt) {
  WorkBudget budget({1.0, 50.0}, 10.0);
  budget.spend(1000 * 4800);
  budget.earn(from_seconds(1.0));
  EXPECT_EQ(budget.grant(kAll), 800);
  budget.start();
  EXPECT_EQ(budget.grant(kAll), 140000);
}

TEST(WorkBudgetConfig, RefusesFiguresOutOfRange) {
  EXPECT_NO_THROW(validate(WorkBudgetConfig{1.0, 1.0}));
  EXPECT_THROW(validate(WorkBudgetConfig{0.0, 50.0}), std::invalid_argument);
  EXPECT_THROW(validate(WorkBudgetConfig{2.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
