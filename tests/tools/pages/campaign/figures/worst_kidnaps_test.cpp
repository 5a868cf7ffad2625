#include "tools/pages/campaign/figures/campaign_figures.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

WorstKidnap lost_for(int cell, double lost_s, std::optional<double> error = std::nullopt) {
  WorstKidnap worst;
  worst.cell = cell;
  worst.kidnap = {kidnap_of("a", 1.0, std::nullopt), 0, lost_s};
  worst.largest_error_m = error;
  return worst;
}

std::vector<int> cells_of(const WorstKidnaps& worst) {
  std::vector<int> cells;
  for (const WorstKidnap& each : worst.kidnaps()) cells.push_back(each.cell);
  return cells;
}

TEST(WorstKidnaps, AreThoseLostForLongest) {
  WorstKidnaps worst(2);
  for (const int cell : {3, 9, 1, 7}) worst.add(lost_for(cell, cell));
  EXPECT_EQ(cells_of(worst), (std::vector<int>{9, 7}));
}

TEST(WorstKidnaps, AmongEqualOnesTheUnrecoveredAndTheLargerErrorComeFirst) {
  WorstKidnaps worst(9);
  WorstKidnap recovered = lost_for(1, 5.0, 99.0);
  recovered.kidnap.kidnap.recovered = true;
  worst.add(recovered);
  worst.add(lost_for(4, 5.0, 2.0));
  worst.add(lost_for(3, 5.0, 8.0));
  worst.add(lost_for(2, 5.0));
  worst.add(lost_for(0, 5.0));
  EXPECT_EQ(cells_of(worst), (std::vector<int>{3, 4, 0, 2, 1}));
}

}  // namespace
}  // namespace castaway::testbed
