// castaway bench published: one short run.
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

TEST(Bench, RefusesWhatItDoesNotKnow) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "bench").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench nothing").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench published --seeds 0").exit_code, 2);
  EXPECT_EQ(castaway(folder, "bench published --scenario gone.yaml").exit_code, 2);
}

}  // namespace
}  // namespace castaway::test
