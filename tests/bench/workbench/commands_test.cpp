// Runs workbench like a developer.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// `program.hpp` runs the program that CASTAWAY_PROGRAM names.
Outcome workbench(const fs::path& folder, const std::string& arguments) {
  return castaway(folder, arguments);
}

void write_scenario(const fs::path& folder) {
  std::ofstream(folder / "trial.yaml")
      << "duration_s: 2\ndrive: {route: none}\nlocalizers: [amcl]\n";
}

TEST(Workbench, PrintsALineForEveryPublishedVariant) {
  const fs::path folder = fresh_folder();
  write_scenario(folder);
  const Outcome outcome = workbench(folder, "published --scenario trial.yaml --seeds 1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 21) << outcome.out;
  expect_contains(outcome.out, "+ summed_weights ");
  expect_contains(outcome.out, "\npublished ");
}

TEST(Workbench, PrintsJsonOfPublishedVariants) {
  const fs::path folder = fresh_folder();
  write_scenario(folder);
  const Outcome outcome = workbench(folder, "published --scenario trial.yaml --seeds 1 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 20U);
  EXPECT_EQ(rows[0].at("variant"), "paper");
  EXPECT_EQ(rows[0].at("events"), 0);
  EXPECT_TRUE(rows[0].at("recovery_time_s").is_null());
  EXPECT_LT(rows[0].at("tracking_error_m"), 0.3);
}

TEST(Workbench, PrintsDriftOfProfiles) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = workbench(folder, "odometry --seeds 1 --duration 30 --length 2");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "worn-wheels");
}

TEST(Workbench, ComparesTheDriveWithClosedForms) {
  const Outcome outcome = workbench(fresh_folder(), "physics --physics-hz 240");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "straight line from rest, 10 s");
}

TEST(Workbench, CountsStepsThroughWalls) {
  const Outcome outcome = workbench(fresh_folder(), "crowds --hours 0.01");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, " 0 steps through walls, 0 into walls");
}

TEST(Workbench, RefusesWhatItDoesNotKnow) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(workbench(folder, "").exit_code, 2);
  EXPECT_EQ(workbench(folder, "nothing").exit_code, 2);
  EXPECT_EQ(workbench(folder, "published --seeds 0").exit_code, 2);
  EXPECT_EQ(workbench(folder, "published --scenario gone.yaml").exit_code, 2);
  EXPECT_EQ(workbench(folder, "odometry gone.clf").exit_code, 2);
  EXPECT_EQ(workbench(folder, "crowds --people 900").exit_code, 2);
}

}  // namespace
}  // namespace castaway::test
