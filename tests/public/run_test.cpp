// castaway::run and castaway::evaluate, with localizers of one's own.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "castaway/evaluate.hpp"
#include "castaway/run.hpp"
#include "tests/support/dead_reckoning.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway {
namespace {

using Json = nlohmann::json;
using testbed::contains;
using testbed::error_of;
using testbed::TemporaryFolder;

Scenario short_scenario() {
  Scenario scenario{"lab/kidnap"};
  scenario.set("duration_s", "3").set("events", "[]").set("outputs.snapshots", "false");
  return scenario;
}

OwnLocalizer dead_reckoning(LocalizerSetup* told = nullptr) {
  return {"mine", [told](const LocalizerSetup& setup) {
            if (told != nullptr) *told = setup;
            return std::make_unique<test::DeadReckoning>();
          }};
}

TEST(Run, TakesLocalizersOfOnesOwn) {
  const TemporaryFolder folder;
  LocalizerSetup told;
  const RunResult result =
      run(short_scenario(), {folder.path() / "run", {"mh_amcl", dead_reckoning(&told)}});
  const Json summary = Json::parse(result.summary);
  EXPECT_TRUE(summary.at("localizers").contains("mh_amcl"));
  EXPECT_TRUE(summary.at("localizers").contains("mine"));
  EXPECT_TRUE(result.failed.empty());
  EXPECT_EQ(told.name, "mine");
  EXPECT_NE(told.seed, 0U);
  EXPECT_GT(told.map.cells.size(), 0U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "run/report.html"));
}

/// The program has no such localizer.
TEST(Run, LeavesAScenarioThatSaysWhoMadeTheLocalizer) {
  const TemporaryFolder folder;
  run(short_scenario(), {folder.path() / "run", {dead_reckoning()}});
  const Scenario again{(folder.path() / "run/scenario.yaml").string()};
  EXPECT_TRUE(contains(effective_text(again), "own:\n"));
  EXPECT_TRUE(contains(error_of([&] { run(again, {folder.path() / "again"}); }),
                       "localizer 'mine': is an object of the program that made the run"));
}

TEST(Run, WritesTheSameBytesWhateverRidesAlong) {
  const TemporaryFolder folder;
  run(short_scenario(), {folder.path() / "one", {"amcl"}});
  run(short_scenario(), {folder.path() / "two", {"amcl", dead_reckoning()}});
  const auto poses = [&](const char* name) {
    return testbed::read_file(folder.path() / name / "amcl.tum");
  };
  EXPECT_EQ(poses("one"), poses("two"));
}

TEST(Run, SaysWhatExpectationWasMissed) {
  const TemporaryFolder folder;
  Scenario scenario = short_scenario();
  scenario.set("expect", "{mine.position_error_m.max: '< 0'}");
  const RunResult result = run(scenario, {folder.path() / "run", {dead_reckoning()}});
  ASSERT_EQ(result.missed.size(), 1U);
  EXPECT_TRUE(contains(result.missed[0], "mine.position_error_m.max"));
}

TEST(Run, PassesOnWhatALocalizerOfOnesOwnThrows) {
  const TemporaryFolder folder;
  const OwnLocalizer failing{"mine", [](const LocalizerSetup&) -> std::unique_ptr<Localizer> {
                               throw std::logic_error("no idea");
                             }};
  EXPECT_EQ(error_of([&] {
              run(short_scenario(), {folder.path() / "run", {failing}});
            }),
            "no idea");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run/summary.json"));
}

TEST(Evaluate, TakesLocalizersOfOnesOwn) {
  const TemporaryFolder folder;
  Scenario scenario = short_scenario();
  scenario.set("outputs", "{snapshots: false, carmen: true, map: true}");
  run(scenario, {folder.path() / "log", {"amcl"}});
  EvaluateOptions options;
  options.starts = 2;
  options.kidnaps = 1;
  options.window_s = 1.0;
  const std::vector<std::string> rows =
      evaluate({folder.path() / "log"}, {"mh_amcl", dead_reckoning()}, options);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(Json::parse(rows[0]).at("localizer"), "mh_amcl");
  EXPECT_EQ(Json::parse(rows[1]).at("localizer"), "mine");
  EXPECT_EQ(Json::parse(rows[1]).at("starts").at("trials"), 2);
}

}  // namespace
}  // namespace castaway
