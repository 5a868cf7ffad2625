#include "tools/batch/compare/experiment_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/experiment_outcomes.hpp"

namespace castaway::testbed {
namespace {

TextTable table_of(int number) {
  const Experiment experiment = paper_experiment(number, 1, false);
  const std::vector<ExperimentOutcome> outcomes{outcome_with(experiment, 1, 1.0),
                                                outcome_with(experiment, 2, 3.0)};
  return experiment_table(experiment, summarise(experiment, outcomes, two_runs_of_rows()),
                          timing_of(outcomes));
}

std::vector<std::string> row(const TextTable& table, const std::string& label) {
  for (const auto& cells : table.rows) {
    if (cells[0] == label) return cells;
  }
  return {};
}

TEST(ExperimentTable, SetsThePapersFiguresBesideThese) {
  using Cells = std::vector<std::string>;
  const TextTable tracking = table_of(1);
  EXPECT_EQ(tracking.head, (Cells{"", "paper: MH-AMCL", "paper: AMCL", "a"}));
  EXPECT_EQ(
      row(tracking, "error, mean +- sd [m]"),
      (Cells{"error, mean +- sd [m]", "0.109 +- 0.039", "0.206 +- 0.098", "2.1000 +- 2.0000"}));
  EXPECT_EQ(row(tracking, "CPU per update [ms]").at(3), "0.50");
  const TextTable recovery = table_of(2);
  EXPECT_EQ(row(recovery, "recovery time, mean [s]").at(2), "13.714");
  EXPECT_EQ(row(recovery, "success").at(3).substr(0, 8), "100.00 %");
  EXPECT_EQ(row(table_of(3), "emergency stops"), (Cells{"emergency stops", "0", "", "3 (3 to 3)"}));
}

TEST(ExperimentTable, HasARowForEveryFigureOfThePaper) {
  for (const int number : {1, 2, 3}) {
    const TextTable table = table_of(number);
    for (const PaperFigure& figure : paper_experiment(number, 1, false).paper) {
      ASSERT_FALSE(row(table, figure.label).empty()) << figure.label;
      EXPECT_EQ(row(table, figure.label).at(1), figure.mh_amcl);
    }
    for (const auto& cells : table.rows) EXPECT_EQ(cells.size(), table.head.size());
  }
}

}  // namespace
}  // namespace castaway::testbed
