#include "tools/pages/campaign/figures/key_figures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/run/metrics/statistics/intervals.hpp"

namespace castaway::testbed {
namespace {

CellRow at(const std::string& range, const std::string& kind) {
  CellRow row;
  row.values = {{"range", range}, {"kind", kind}};
  return row;
}

KeyFigures two_axes() {
  return {{KeyAxis("range", {"3", "6"}, false), KeyAxis("kind", {"push", "carry"}, false)}, 2};
}

TEST(KeyFigures, PoolsTheOtherKeys) {
  KeyFigures figures = two_axes();
  figures.add(at("3", "push"), 0, "error", 1.0);
  figures.add(at("3", "carry"), 0, "error", 3.0);
  figures.add(at("6", "carry"), 0, "error", 5.0);
  EXPECT_EQ(figures.overall(0, "error")->mean.mean(), 3.0);
  EXPECT_EQ(figures.find(0, 0, 0, "error")->mean.mean(), 2.0);
  EXPECT_EQ(figures.find(0, 1, 0, "error")->mean.count(), 1);
  EXPECT_EQ(figures.find(1, 1, 0, "error")->mean.mean(), 4.0);
  EXPECT_EQ(figures.find(0, 0, 1, "error"), nullptr);
  EXPECT_EQ(figures.overall(1, "error"), nullptr);
}

TEST(KeyFigures, OfTrialsHaveWilsonsInterval) {
  KeyFigures figures = two_axes();
  for (const bool success : {true, true, false}) {
    figures.add_trial(at("3", "push"), 1, "recovered", success);
  }
  const PooledFigure& figure = *figures.find(0, 0, 1, "recovered");
  EXPECT_DOUBLE_EQ(figure.mean.mean(), 2.0 / 3.0);
  EXPECT_EQ(figure.interval()->low, wilson_interval(2, 3).low);
  EXPECT_EQ(figure.interval()->high, wilson_interval(2, 3).high);
}

TEST(KeyFigures, AreWrittenForTheScript) {
  KeyFigures figures = two_axes();
  figures.add(at("6", "push"), 0, "error", 0.25);
  figures.add(at("6", "carry"), 0, "error", 0.75);
  const auto json = key_figures_json(figures, {"a", "run"}, {4, -1});
  EXPECT_EQ(json.at("series"), (std::vector<std::string>{"a", "run"}));
  EXPECT_EQ(json.at("names"), std::vector<std::string>{"error"});
  EXPECT_EQ(json.at("styles"), (std::vector<int>{4, -1}));
  EXPECT_EQ(json.at("units"), std::vector<std::string>{""});
  const auto& axis = json.at("axes").at(0);
  EXPECT_EQ(axis.at("key"), "range");
  EXPECT_EQ(axis.at("x"), (std::vector<int>{3, 6}));
  const auto& drawn = axis.at("figures").at(0);
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].at("at"), std::vector<int>{1});
  EXPECT_EQ(drawn[0].at("y"), std::vector<double>{0.5});
  EXPECT_EQ(drawn[0].at("n"), std::vector<int>{2});
  EXPECT_EQ(json.at("axes").at(1).at("labels"), (std::vector<std::string>{"push", "carry"}));
}

}  // namespace
}  // namespace castaway::testbed
