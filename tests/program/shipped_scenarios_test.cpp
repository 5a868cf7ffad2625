// Runs every shipped scenario twice; both runs must give the same bytes.
#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

const fs::path kWorlds = fs::path(CASTAWAY_SOURCE_DIR) / "worlds";

std::vector<std::string> scenarios() {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(kWorlds)) {
    const fs::path& path = entry.path();
    if (path.parent_path().filename() == "scenarios") {
      files.push_back(fs::relative(path, kWorlds).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Hashes of all files of a run except for timing.
std::map<std::string, std::size_t> hashes(const fs::path& run) {
  std::map<std::string, std::size_t> result;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    const std::string name = fs::relative(entry.path(), run).string();
    if (!entry.is_regular_file() || name.starts_with("timing")) continue;
    result[name] = std::hash<std::string>()(text_of(entry.path()));
  }
  return result;
}

class ShippedScenarios : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScenarios, GiveTheSameBytesTwice) {
  const fs::path folder = fresh_folder();
  const std::string arguments = "run '" + (kWorlds / GetParam()).string() +
                                "' --duration 4 --set outputs.snapshots=false "
                                "--set outputs.report=false --set expect=~ --out ";
  for (const char* out : {"a", "b"}) {
    const Outcome outcome = castaway(folder, arguments + out);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  const auto first = hashes(folder / "a");
  EXPECT_GE(first.size(), 4U);
  EXPECT_EQ(first, hashes(folder / "b"));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScenarios, testing::ValuesIn(scenarios()), path_name);

TEST(CheckWorld, PrintsJsonAndTakesPictures) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder, "check-world lab --json --out lab.png");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "\"furniture\": 44");
  expect_contains(outcome.out, "\"twins\": 0.0");
  EXPECT_GT(fs::file_size(folder / "lab.png"), 10000U);
  EXPECT_GT(fs::file_size(folder / "lab-map.png"), 3000U);
}

TEST(CheckWorld, TakesTheWorldOfAScenario) {
  const fs::path folder = fresh_folder();
  const std::string scenario = (kWorlds / "lab/scenarios/moved.yaml").string();
  const Outcome outcome = castaway(folder, "check-world --no-picture --scenario " + scenario);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "difference: ");
  EXPECT_EQ(outcome.out.find("difference: 0.00"), std::string::npos) << outcome.out;
}

TEST(RunInADifferentWorld, ReportsTheDifference) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "run '" + (kWorlds / "lab/scenarios/moved.yaml").string() +
                           "' --duration 2 --set outputs.snapshots=false --out run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "The world is not as mapped");
  expect_contains(text_of(folder / "run/summary.json"), "\"difference\"");
  expect_contains(text_of(folder / "run/scenario.yaml"), "move_furniture: 0.35");
}

}  // namespace
}  // namespace castaway::test
