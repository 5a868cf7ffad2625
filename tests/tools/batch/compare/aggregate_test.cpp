#include "tools/batch/compare/aggregate.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

TEST(AggregateFigures, SumUpEveryFigureOverTheRunsThatHaveIt) {
  const Json json = aggregate_figures(
      {{{"a", 1.0}, {"b", std::nullopt}}, {{"a", 3.0}, {"b", 5.0}}, {{"a", 8.0}}});
  EXPECT_EQ(json.at("a").at("runs"), 3);
  EXPECT_EQ(json.at("a").at("mean"), 4.0);
  EXPECT_EQ(json.at("a").at("median"), 3.0);
  EXPECT_EQ(json.at("a").at("min"), 1.0);
  EXPECT_EQ(json.at("a").at("max"), 8.0);
  EXPECT_EQ(json.at("a").at("mean_interval").size(), 2U);
  EXPECT_EQ(json.at("b").at("runs"), 1);
  EXPECT_TRUE(json.at("b").at("mean_interval").is_null());
  EXPECT_TRUE(aggregate_figures({}).empty());
}

Json run_with(int events, const std::vector<double>& times) {
  Json recovery{{"events", events}, {"each", Json::array()}};
  for (int i = 0; i < events; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const bool recovered = index < times.size();
    recovery["each"].push_back({{"recovered", recovered},
                                {"time_s", recovered ? Json(times[index]) : Json()},
                                {"distance_m", recovered ? Json(1.0) : Json()}});
  }
  return {{"localizers", {{"a", {{"recovery", recovery}}}}}};
}

TEST(PooledRecoveries, AreOneSample) {
  const Json json = pooled_recoveries({run_with(2, {1.0, 2.0}), run_with(3, {6.0})});
  const Json& recovery = json.at("a").at("recovery");
  EXPECT_EQ(recovery.at("events"), 5);
  EXPECT_EQ(recovery.at("recovered"), 3);
  EXPECT_EQ(recovery.at("success"), 0.6);
  EXPECT_EQ(recovery.at("success_interval").size(), 2U);
  EXPECT_EQ(recovery.at("/time_s/mean"_json_pointer), 3.0);
  EXPECT_EQ(recovery.at("/time_s/max"_json_pointer), 6.0);
  EXPECT_EQ(recovery.at("/distance_m/mean"_json_pointer), 1.0);
  EXPECT_FALSE(recovery.contains("each"));
}

}  // namespace
}  // namespace castaway::testbed
