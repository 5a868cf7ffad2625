#include "tools/pages/campaign/figures/recovery_curves.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

RecoveryCurves one_axis() { return {{KeyAxis("range", {"3", "6"}, false)}, 2}; }

void add_kidnap(RecoveryCurves& curves, const std::string& range, std::size_t series,
                std::optional<double> time_s) {
  CellRow row;
  row.values = {{"range", range}};
  curves.add(row, series, {kidnap_of("a", 1.0, time_s), 0, time_s.value_or(20.0)});
}

TEST(RecoveryCurves, AreOverallAndAtEachValue) {
  RecoveryCurves curves = one_axis();
  add_kidnap(curves, "3", 0, 1.0);
  add_kidnap(curves, "6", 0, std::nullopt);
  add_kidnap(curves, "6", 1, 4.0);
  EXPECT_EQ(curves.overall(0).size(), 2);
  EXPECT_EQ(curves.at(0, 0, 0).events(), 1);
  EXPECT_EQ(curves.at(0, 1, 0).censored(), 1);
  EXPECT_EQ(curves.at(0, 0, 1).size(), 0);
}

TEST(RecoveryCurves, AreDrawnAsStairs) {
  RecoveryCurves curves = one_axis();
  add_kidnap(curves, "3", 0, 1.0);
  add_kidnap(curves, "3", 0, 3.0);
  add_kidnap(curves, "3", 0, std::nullopt);
  add_kidnap(curves, "3", 0, std::nullopt);
  const auto json = recovery_curves_json(curves, {"a", "b"}, {3, 1});
  ASSERT_EQ(json.size(), 2U);
  const auto& line = json[0].at("plots").at(0).at("series").at(0);
  EXPECT_EQ(line.at("name"), "a (n = 4)");
  EXPECT_EQ(line.at("x"), (std::vector<int>{0, 1, 1, 3, 3, 20}));
  EXPECT_EQ(line.at("y"), (std::vector<double>{1, 1, 0.75, 0.75, 0.5, 0.5}));
  // S^exp(+-1.96 sqrt(g) / log S), with g = 1/(4 * 3), then 1/(4 * 3) + 1/(3 * 2).
  EXPECT_EQ(line.at("low"), (std::vector<double>{1, 1, 0.128, 0.128, 0.0578, 0.0578}));
  EXPECT_EQ(line.at("high"), (std::vector<double>{1, 1, 0.961, 0.961, 0.845, 0.845}));
  EXPECT_EQ(line.at("style"), "band");
  EXPECT_EQ(line.at("color"), 3);
  EXPECT_EQ(json[1].at("plots").size(), 2U);
  EXPECT_EQ(json[1].at("plots").at(1).at("title"), "range = 6");
  EXPECT_TRUE(json[1].at("plots").at(1).at("series").at(0).at("x").empty());
}

TEST(RecoveryCurves, OfManyKidnapsStaySmall) {
  RecoveryCurves curves = one_axis();
  for (int i = 0; i < 10000; ++i) add_kidnap(curves, "3", 0, 0.01 * (i % 5000));
  const auto json = recovery_curves_json(curves, {"a", "b"}, {3, 1});
  const auto& y = json[0].at("plots").at(0).at("series").at(0).at("y");
  EXPECT_LT(y.size(), 300U);
  EXPECT_EQ(y.back(), 0);
}

}  // namespace
}  // namespace castaway::testbed
