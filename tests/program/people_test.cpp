// Tests castaway run with people, and the metrics of people.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const std::string kNoEvents =
    "--set outputs.snapshots=false --set outputs.report=false --set events=[] ";

TEST(People, AreInTheSummaryAndInATableOfTheirOwn) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "run --duration 6 --set people.count=5 --out run " + kNoEvents);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "5 people: ");
  const Json people = Json::parse(text_of(folder / "run/summary.json")).at("people");
  EXPECT_EQ(people.at("people"), 5);
  EXPECT_GT(people.at("closest_m"), 0.0);
  EXPECT_GT(people.at("/beams_on_people/max"_json_pointer), 0.0);
  const std::string rows = text_of(folder / "run/people.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + 5 * 12);
  expect_contains(text_of(folder / "run/scenario.yaml"), "behaviour: regular");
}

TEST(People, RepeatToTheByteAndFromTheScenarioTheyLeave) {
  const fs::path folder = fresh_folder();
  const std::string people =
      "run --duration 6 --set 'people={count: 8, behaviour: mixed, groups: "
      "0.5, talking: [2], crowd: {blocked: 0.3}}' ";
  ASSERT_EQ(castaway(folder, people + "--out a " + kNoEvents).exit_code, 0);
  ASSERT_EQ(castaway(folder, people + "--out b " + kNoEvents).exit_code, 0);
  ASSERT_EQ(castaway(folder, "run a/scenario.yaml --out c").exit_code, 0);
  for (const char* file : {"people.csv", "errors.csv", "truth.tum", "summary.json"}) {
    const std::string text = text_of(folder / "a" / file);
    EXPECT_FALSE(text.empty()) << file;
    EXPECT_TRUE(text == text_of(folder / "b" / file)) << file;
    EXPECT_TRUE(text == text_of(folder / "c" / file)) << file;
  }
}

/// An additional localizer changes neither the robot's path nor those of people.
TEST(People, DoNotCareWhoIsLocalizing) {
  const fs::path folder = fresh_folder();
  const std::string people = "run --duration 6 --set people.count=8 ";
  ASSERT_EQ(castaway(folder, people + "--out a " + kNoEvents).exit_code, 0);
  ASSERT_EQ(castaway(folder, people + "--set localizers=[amcl] --out b " + kNoEvents).exit_code, 0);
  EXPECT_TRUE(text_of(folder / "a/people.csv") == text_of(folder / "b/people.csv"));
  EXPECT_TRUE(text_of(folder / "a/truth.tum") == text_of(folder / "b/truth.tum"));
}

TEST(People, ShippedScenariosRun) {
  const fs::path folder = fresh_folder();
  for (const char* name : {"people", "crowd"}) {
    const std::string file =
        std::string(CASTAWAY_SOURCE_DIR) + "/worlds/lab/scenarios/" + name + ".yaml";
    const Outcome outcome =
        castaway(folder, "run " + file + " --duration 3 --out run " + kNoEvents);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

TEST(People, WrongKeysAreNamed) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder, "run --set people.behavior=curious");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "behaviour");
}

TEST(BenchSimulation, PrintsATable) {
  const fs::path folder = fresh_folder();
  const Outcome words = castaway(folder, "bench simulation --quick --duration 2");
  ASSERT_EQ(words.exit_code, 0) << words.err;
  expect_contains(words.out, "hall, 60 boxes");
  expect_contains(words.out, "lab, kinematic");
  const Outcome json = castaway(folder, "bench simulation --quick --duration 2 --json");
  const Json root = Json::parse(json.out);
  EXPECT_EQ(root.at("runs").size(), 4U);
  EXPECT_EQ(root.at("casts").size(), 4U);
}

}  // namespace
}  // namespace castaway::test
