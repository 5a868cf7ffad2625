#include "localization/search/work_budget.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

constexpr std::int64_t kAll = std::int64_t{1} << 40;

TEST(WorkBudget, StartsWithWhatOneScanMayCost) {
  const WorkBudget budget({1.0, 50.0}, 10.0);
  EXPECT_EQ(budget.grant(kAll), 200000);  // Half of 50 ms; the rest weighs the places found.
  EXPECT_EQ(budget.grant(300), 300);
}

TEST(WorkBudget, EarnsAShareForEveryScanThatIsDue) {
  WorkBudget budget({1.0, 50.0}, 10.0);
  budget.earn(from_seconds(1.0));
  budget.spend(100000);
  budget.earn(from_seconds(1.1));
  EXPECT_EQ(budget.grant(kAll), 100000 + 4800);  // 1 ms less 0.4 ms for tracking.
  budget.earn(from_seconds(1.12));
  EXPECT_EQ(budget.grant(kAll), 100000 + 2 * 4800);
  budget.earn(from_seconds(1.62));
  EXPECT_EQ(budget.grant(kAll), 100000 + 7 * 4800);
  budget.earn(from_seconds(1000.0));
  EXPECT_EQ(budget.grant(kAll), 200000);
}

TEST(WorkBudget, GrantsALittleEvenInDebt) {
  WorkBudget budget({1.0, 50.0}, 10.0);
  budget.spend(1000000);
  EXPECT_EQ(budget.grant(kAll), 800);
  budget.earn(from_seconds(1.0));
  EXPECT_EQ(budget.grant(kAll), 800);
  budget.start();
  EXPECT_EQ(budget.grant(kAll), 200000);
}

TEST(WorkBudgetConfig, RefusesFiguresOutOfRange) {
  EXPECT_NO_THROW(validate(WorkBudgetConfig{1.0, 1.0}));
  EXPECT_THROW(validate(WorkBudgetConfig{0.0, 50.0}), std::invalid_argument);
  EXPECT_THROW(validate(WorkBudgetConfig{2.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
