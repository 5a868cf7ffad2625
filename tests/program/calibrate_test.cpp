// Tests castaway calibrate: a log becomes a twin that castaway run plays.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/tools/support/recorded_office.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kOffice = "office/log.carmen --map office/map.yaml";

fs::path folder_with_office(int scans) {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(scans), folder / "office");
  return folder;
}

TEST(Calibrate, WritesATwinThatRuns) {
  const fs::path folder = folder_with_office(1200);
  const Outcome outcome = castaway(folder, std::string("calibrate ") + kOffice + " --out twin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  expect_contains(outcome.out, "1200 scans aligned by reference poses, 0 left out");
  expect_contains(outcome.out, "castaway run twin/scenario.yaml");
  for (const char* name : {"scenario.yaml", "map.yaml", "map.pgm", "path.tum", "lidar.yaml",
                           "odometry.yaml", "people.yaml", "calibration.json", "world.yaml",
                           "world.pgm", "scan_times.txt", "calibration.html"}) {
    EXPECT_TRUE(fs::exists(folder / "twin" / name)) << name;
  }
  const Json figures = Json::parse(text_of(folder / "twin/calibration.json"));
  EXPECT_NEAR(figures.at("/odometry/scale/value"_json_pointer), 0.0, 0.005);  // It is exact.
  EXPECT_NEAR(figures.at("/odometry/yaw_scale/value"_json_pointer), 0.0, 0.005);
  EXPECT_NEAR(figures.at("/stamps/rate_hz"_json_pointer), 5.0, 1e-6);
  EXPECT_EQ(figures.at("/people/value"_json_pointer), 0.0);
  EXPECT_EQ(figures.at("likeness").size(), 4U);
  const Outcome run = castaway(
      folder, "run twin/scenario.yaml --out run --duration 20 --set outputs.snapshots=false");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  // The robot drives in a circle of 1.5 m: 2 cm to the side are 1.3 % of the way.
  EXPECT_NEAR(Json::parse(text_of(folder / "run/summary.json")).at("distance_m"), 10.0, 0.1);
}

TEST(Calibrate, SaysBeforeThePlayThatOdometryIsIdeal) {
  const fs::path folder = folder_with_office(60);
  const Outcome outcome = castaway(folder, std::string("calibrate ") + kOffice + " --out twin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("Play it: "), std::string::npos);
  expect_contains(outcome.out,
                  "\nIts odometry is ideal, not the log's: the robot drove too little");
}

TEST(Calibrate, GivesTheSameBytesAgain) {
  const fs::path folder = folder_with_office(100);
  const std::string line = std::string("calibrate ") + kOffice + " --json --out ";
  const Outcome first = castaway(folder, line + "a");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(castaway(folder, line + "b").out, first.out);
  EXPECT_EQ(text_of(folder / "a/scenario.yaml"), text_of(folder / "b/scenario.yaml"));
}

TEST(Calibrate, AlignsWithoutReferencePoses) {
  const fs::path folder = folder_with_office(150);
  const Outcome outcome =
      castaway(folder, std::string("calibrate ") + kOffice + " --align mh_amcl --out twin --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json figures = Json::parse(outcome.out);
  EXPECT_EQ(figures.at("aligned_by"), "mh_amcl");
  EXPECT_GE(figures.at("scans"), 140);
}

TEST(Calibrate, RefusesWhatItCannotUse) {
  const fs::path folder = folder_with_office(30);
  expect_refused(castaway(folder, std::string("calibrate ") + kOffice + " --out twin"),
                 {"log.carmen", "30 scans", "at least 50"});
  EXPECT_FALSE(fs::exists(folder / "twin"));
  expect_refused(castaway(folder, "calibrate office/log.carmen --out twin"), {"--map"});
  expect_refused(castaway(folder, "calibrate nowhere --map office/map.yaml --out twin"),
                 {"nowhere", "no such file"});
  expect_refused(castaway(folder, "calibrate office --align exact --out twin"), {"--align"});
  EXPECT_EQ(castaway(folder, "map home --out home.yaml").exit_code, 0);
  testbed::write_office(testbed::recorded_office(60), folder / "office");
  expect_refused(castaway(folder, "calibrate office/log.carmen --map home.yaml --out twin"),
                 {"log.carmen", "% of the scans' end points", "belong together"});
  write(folder / "mine/notes.txt", "keep");
  expect_refused(castaway(folder, "calibrate office --out mine"), {"mine"});
  EXPECT_EQ(text_of(folder / "mine/notes.txt"), "keep");
}

}  // namespace
}  // namespace castaway::test
