// Tests castaway lidars, and castaway run with sensor errors and faults.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const std::string kNoReport = "--set outputs.snapshots=false --set outputs.report=false ";
const std::string kScenarios = std::string(CASTAWAY_SOURCE_DIR) + "/worlds/lab/scenarios/";

TEST(Lidars, AreListedWithTheirFigures) {
  const fs::path folder = fresh_folder();
  const Outcome table = castaway(folder, "lidars");
  EXPECT_EQ(table.exit_code, 0);
  expect_contains(table.out, "ROBOTIS HLS-LFCD2");
  const Json list = Json::parse(castaway(folder, "lidars --json").out);
  const auto lds = std::find_if(list.begin(), list.end(),
                                [](const Json& entry) { return entry.at("name") == "lds-01"; });
  ASSERT_NE(lds, list.end());
  EXPECT_EQ(lds->at("range_max_m"), 3.5);
}

TEST(Lidars, AnUnknownOneIsAnError) {
  const Outcome outcome = castaway(fresh_folder(), "run --set lidar.profile=lds-001");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "did you mean 'lds-01'?");
}

TEST(Sensors, RepeatToTheByteWithEveryErrorOn) {
  const fs::path folder = fresh_folder();
  const std::string run = "run " + kScenarios + "real-lidar.yaml --duration 6 --set events=[] " +
                          kNoReport + "--set outputs.scans=true --set lidar.noise.dust_per_m=0.01 ";
  ASSERT_EQ(castaway(folder, run + "--out a").exit_code, 0);
  ASSERT_EQ(castaway(folder, "run a/scenario.yaml --out b").exit_code, 0);
  for (const char* file : {"scans.csv", "labels.csv", "errors.csv", "truth.tum", "summary.json"}) {
    const std::string text = text_of(folder / "a" / file);
    EXPECT_FALSE(text.empty()) << file;
    EXPECT_TRUE(text == text_of(folder / "b" / file)) << file;
  }
}

/// Recording more data of a lidar does not change a run.
TEST(Sensors, WritingScansChangesNothing) {
  const fs::path folder = fresh_folder();
  const std::string run = "run --duration 4 --set events=[] " + kNoReport;
  ASSERT_EQ(castaway(folder, run + "--out a").exit_code, 0);
  ASSERT_EQ(castaway(folder, run + "--set outputs.scans=true --out b").exit_code, 0);
  EXPECT_TRUE(text_of(folder / "a/errors.csv") == text_of(folder / "b/errors.csv"));
  expect_contains(text_of(folder / "b/labels.csv"), "object outer-wall");
}

TEST(Sensors, PointsOfALayeredLidarAreWritten) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "run " + kScenarios + "lidar-3d.yaml --duration 1 " + kNoReport +
                                 "--set lidar.beams=90 --out a")
                .exit_code,
            0);
  expect_contains(text_of(folder / "a/points/lidar-0000000.ply"), "element vertex 1");
}

TEST(Sensors, FaultsAreScored) {
  const fs::path folder = fresh_folder();
  const std::string fault = "'events=[{fault: {kind: lidar-dropout, at_s: 2, for_s: 1}}]' ";
  ASSERT_EQ(castaway(folder, "run --duration 6 " + kNoReport + "--out a --set " + fault).exit_code,
            0);
  const Json faults = Json::parse(text_of(folder / "a/summary.json")).at("faults");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].at("fault"), "lidar-dropout");
  EXPECT_EQ(faults[0].at("end_s"), 3.0);
  EXPECT_LT(faults[0].at("/localizers/mh_amcl/mean_error_m"_json_pointer), 0.5);
  expect_contains(text_of(folder / "a/events.csv"), "fault off,lidar-dropout");
}

}  // namespace
}  // namespace castaway::test
