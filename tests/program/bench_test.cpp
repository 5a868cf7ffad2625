// Short tests of castaway bench published and localization.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

void write_scenario(const fs::path& folder) {
  std::ofstream(folder / "trial.yaml")
      << "duration_s: 2\ndrive: {route: none}\nlocalizers: [amcl]\n";
}

TEST(BenchPublished, PrintsALineForEveryVariant) {
  const fs::path folder = fresh_folder();
  write_scenario(folder);
  const Outcome outcome = castaway(folder, "bench published --scenario trial.yaml --seeds 1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 21) << outcome.out;
  expect_contains(outcome.out, "+ summed_weights ");
  expect_contains(outcome.out, "\npublished ");
}

TEST(BenchPublished, PrintsJson) {
  const fs::path folder = fresh_folder();
  write_scenario(folder);
  const Outcome outcome =
      castaway(folder, "bench published --scenario trial.yaml --seeds 1 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 20U);
  EXPECT_EQ(rows[0].at("variant"), "paper");
  EXPECT_EQ(rows[0].at("events"), 0);
  EXPECT_TRUE(rows[0].at("recovery_time_s").is_null());
  EXPECT_LT(rows[0].at("tracking_error_m"), 0.3);
}

TEST(BenchLocalization, PrintsTimesBesideTheReference) {
  const fs::path folder = fresh_folder();
  const Outcome words = castaway(folder, "bench localization --quick");
  ASSERT_EQ(words.exit_code, 0) << words.err;
  expect_contains(words.out, "whole update");
  expect_contains(words.out, "20 x 15 m");
  const Outcome json = castaway(folder, "bench localization --quick --json");
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const auto root = nlohmann::json::parse(json.out);
  EXPECT_EQ(root.at("steps").size(), 6U);
  EXPECT_EQ(root.at("match").size(), 2U);
  EXPECT_GT(root.at("/steps/5/ratio"_json_pointer), 1.0);
}

TEST(Bench, RefusesWhatItDoesNotKnow) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "bench").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench nothing").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench published --seeds 0").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench published --scenario gone.yaml").exit_code, 2);
}

}  // namespace
}  // namespace castaway::test
