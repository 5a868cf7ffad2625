// Tests castaway evaluate on a log that the test writes, and on recorded logs if available.
#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/tools/support/recorded_office.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

TEST(Evaluate, JudgesALocalizerOnALog) {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(100), folder / "office");
  const std::string arguments = "evaluate office --starts 2 --kidnaps 1 --window 6";
  const Outcome outcome = castaway(folder, arguments + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Json rows = Json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("log"), "office");
  EXPECT_EQ(rows[0].at("localizer"), "mh_amcl");
  EXPECT_EQ(rows[0].at("/starts/trials"_json_pointer), 2);
  EXPECT_EQ(rows[0].at("/starts/recovered"_json_pointer), 2);
  EXPECT_NEAR(rows[0].at("/starts/interval/0"_json_pointer), 0.342, 0.001);  // 2 of 2
  EXPECT_EQ(rows[0].at("/kidnaps/trials"_json_pointer), 1);
  EXPECT_LT(rows[0].at("tracking_m"), 0.1);
  EXPECT_LT(rows[0].at("/calibration/brier"_json_pointer), 0.25);
  EXPECT_EQ(rows[0].at("/calibration/bins"_json_pointer).size(), 10U);
  EXPECT_EQ(rows[0].at("detection_delay_s").size(), 1U);
  EXPECT_TRUE(rows[0].at("false_alarms_per_h").is_number());
}

TEST(Evaluate, SplicesKidnapsToLookAlikesWithSeveralWorkers) {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(100), folder / "office");
  const std::string arguments =
      "evaluate office --starts 0 --kidnaps 3 --window 4 --no-tracking --json --kidnap-to ";
  const Outcome far = castaway(folder, arguments + "far");
  const Outcome alike = castaway(folder, arguments + "look-alike -j 2");
  ASSERT_EQ(alike.exit_code, 0) << alike.err;
  const Json row = Json::parse(alike.out).at(0);
  EXPECT_EQ(row.at("/kidnaps/trials"_json_pointer), 3);
  EXPECT_NE(Json::parse(far.out).at(0).at("calibration"), row.at("calibration"));
  expect_refused(castaway(folder, arguments + "twin"), {"--kidnap-to", "look-alike"});
}

TEST(Evaluate, PrintsALineForEveryLocalizer) {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(60), folder / "office");
  const Outcome outcome = castaway(folder,
                                   "evaluate office --starts 1 --kidnaps 0 --window 2 "
                                   "--no-tracking --localizer mh_amcl --localizer amcl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3) << outcome.out;
  expect_contains(outcome.out, "unknown start");
  expect_contains(outcome.out, " amcl ");
  expect_contains(outcome.out, "/1 (");
}

TEST(Evaluate, RefusesAFolderThatHasNotWhatItNeeds) {
  const fs::path folder = fresh_folder();
  expect_refused(castaway(folder, "evaluate gone --json"), {"gone"});
  fs::create_directories(folder / "empty");
  expect_refused(castaway(folder, "evaluate empty --json"), {"empty", "no log"});
  testbed::write_office(testbed::recorded_office(2), folder / "mapless");
  fs::remove(folder / "mapless/map.yaml");
  expect_refused(castaway(folder, "evaluate mapless --json"), {"mapless", "no map"});
}

TEST(Evaluate, TakesBagsOfSqlite) {
  const fs::path folder = fresh_folder();
  fs::create_directories(folder / "log");
  std::ofstream(folder / "log/humble_0.db3") << "SQLite format 3";
  const Outcome outcome = castaway(folder, "evaluate log");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "log/humble_0.db3: is no bag of ROS 2");
}

TEST(Evaluate, TakesRunFoldersOfItsOwn) {
  const fs::path folder = fresh_folder();
  const std::string run = "run --duration 12 --set events=[] --set outputs.snapshots=false ";
  ASSERT_EQ(castaway(folder, run + "--set outputs.carmen=true --set outputs.map=true --out carmen")
                .exit_code,
            0);
  ASSERT_EQ(castaway(folder, run + "--set outputs.bag=true --out bag").exit_code, 0);
  const Outcome outcome = castaway(
      folder, "evaluate carmen bag --starts 2 --kidnaps 0 --window 5 --no-tracking --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json rows = Json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 2U);
  for (const Json& row : rows) EXPECT_EQ(row.at("starts").at("recovered"), 2) << row;
}

TEST(Evaluate, RefusesFiguresThatMakeNoSense) {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(2), folder / "office");
  expect_refused(castaway(folder, "evaluate office --window 0"), {"window"});
  expect_refused(castaway(folder, "evaluate office --starts -1"), {"starts"});
  expect_refused(castaway(folder, "evaluate office --blocked 2"), {"blocked"});
  expect_refused(castaway(folder, "evaluate office --localizer mh_amlc"), {"mh_amlc", "mh_amcl"});
  EXPECT_EQ(castaway(folder, "evaluate").exit_code, 2);
}

TEST(Evaluate, JudgesARecordedLog) {
  const char* root = std::getenv("CASTAWAY_REAL_DATA");
  const fs::path data =
      (root != nullptr ? fs::path(root) : fs::path(CASTAWAY_SOURCE_DIR) / "../shared/data/real") /
      "intel";
  if (!fs::exists(data / "map.yaml")) {
    GTEST_SKIP() << "no recorded log intel (set CASTAWAY_REAL_DATA)";
  }
  const Outcome outcome =
      castaway(fresh_folder(), "evaluate '" + fs::absolute(data).string() +
                                   "' --starts 1 --kidnaps 1 --window 20 --no-tracking --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json row = Json::parse(outcome.out).at(0);
  EXPECT_EQ(row.at("log"), "intel");
  EXPECT_EQ(row.at("/starts/trials"_json_pointer), 1);
  EXPECT_GT(row.at("scans"), 0);
}

}  // namespace
}  // namespace castaway::test
