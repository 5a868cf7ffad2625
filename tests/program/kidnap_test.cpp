// The main use case from end to end: the robot is kidnapped and relocalizes.
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const char* const kShort =
    "run --duration 25 --set events.0.kidnap.at_s=6.03 --set events.1.kidnap.at_s=12.07 "
    "--set events.2.kidnap.at_s=18.5 --set outputs.snapshots=false ";

TEST(Kidnap, IsRecoveredFromInTheDefaultWorld) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder, std::string(kShort) + "--out run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = Json::parse(text_of(folder / "run/summary.json"));
  const Json& mh_amcl = summary.at("localizers").at("mh_amcl");
  EXPECT_EQ(mh_amcl.at("recovery").at("events"), 3);
  EXPECT_EQ(mh_amcl.at("recovery").at("recovered"), 3);
  EXPECT_LT(mh_amcl.at("recovery").at("time_s").at("max"), 6.5);
  EXPECT_LT(mh_amcl.at("tracking_error_m").at("mean"), 0.05);
  EXPECT_EQ(summary.at("collisions"), 0);
  expect_contains(outcome.out, "3 of 3");
  expect_contains(outcome.out, "x real time");
  for (const char* file :
       {"scenario.yaml", "summary.json", "timing.json", "errors.csv", "timing.csv", "events.csv",
        "truth.tum", "mh_amcl.tum", "amcl.tum", "report.html"}) {
    EXPECT_TRUE(fs::exists(folder / "run" / file)) << file;
  }
}

/// Content of every file of a run that must not depend on clocks.
std::map<std::string, std::string> repeatable_files(const fs::path& run) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(run)) {
    const std::string name = fs::relative(entry.path(), run).generic_string();
    if (!entry.is_regular_file() || name == "timing.json" || name == "timing.csv") continue;
    std::string text = text_of(entry.path());
    if (name == "report.html") text = text.substr(0, text.find("timing: begin"));
    files[name] = text;
  }
  return files;
}

TEST(Kidnap, RepeatsToTheByte) {
  const fs::path folder = fresh_folder();
  const std::string arguments =
      "run --duration 8 --set events.0.kidnap.at_s=2 --set events.1.kidnap.at_s=4 --set "
      "events.2.kidnap.at_s=6 --set outputs.snapshots.width=160 --set "
      "outputs.snapshots.height=120 ";
  ASSERT_EQ(castaway(folder, arguments + "--seed 5 --out a").exit_code, 0);
  ASSERT_EQ(castaway(folder, arguments + "--seed 5 --out b").exit_code, 0);
  ASSERT_EQ(castaway(folder, arguments + "--seed 6 --out c").exit_code, 0);
  const auto a = repeatable_files(folder / "a");
  const auto b = repeatable_files(folder / "b");
  EXPECT_GE(a.size(), 8U);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, text] : a) EXPECT_TRUE(text == b.at(name)) << name;
  EXPECT_NE(a.at("errors.csv"), text_of(folder / "c/errors.csv"));
}

TEST(Kidnap, IsReproducedByTheScenarioThatARunLeaves) {
  const fs::path folder = fresh_folder();
  const std::string quick = "--set outputs.snapshots=false --set outputs.report=false ";
  ASSERT_EQ(
      castaway(folder, "run --duration 5 --seed 3 --set events=[] --out a " + quick).exit_code, 0);
  ASSERT_EQ(castaway(folder, "run a/scenario.yaml --out b").exit_code, 0);
  EXPECT_EQ(text_of(folder / "a/errors.csv"), text_of(folder / "b/errors.csv"));
  EXPECT_EQ(text_of(folder / "a/scenario.yaml"), text_of(folder / "b/scenario.yaml"));
}

TEST(Kidnap, ThatComesTooLateIsSaidNotToBeScored) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder,
                                   "run --duration 6 --set \"events=[{kidnap: {kind: teleport, "
                                   "at_s: 3}}]\" --set outputs.snapshots=false "
                                   "--out run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "1 kidnap is not scored: less than 5 s before");
  const std::string page = text_of(folder / "run/report.html");
  expect_contains(page, "was displaced. 1 kidnap is not scored");
  EXPECT_EQ(page.find("never displaced"), std::string::npos);
}

TEST(Run, DrivesByALocalizersEstimate) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder,
                                   "run --duration 15 --set events=[] --set drive.by=mh_amcl --set "
                                   "outputs.snapshots=false --out run --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GT(Json::parse(outcome.out).at("distance_m"), 2.0);
}

TEST(Run, HonoursALidarThatHangsUpsideDownOffCentreAndYawed) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(
      folder,
      "run --duration 15 --set events=[] --set outputs.snapshots=false --set outputs.report=false "
      "--set 'lidar.mount_rpy=[3.14159265,0,0.7]' --set 'lidar.mount_xyz=[0.1,0.08,0.132]' "
      "--set start=unknown --out run --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json mh_amcl = Json::parse(outcome.out).at("localizers").at("mh_amcl");
  EXPECT_EQ(mh_amcl.at("recovery").at("recovered"), 1);
  EXPECT_LT(mh_amcl.at("tracking_error_m").at("mean"), 0.05);
}

TEST(Kidnap, GoesToTheGivenPose) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder,
               "run --duration 8 --set 'events=[{kidnap: {at_s: 2, pose: [2.0, 3.5, 1.0]}}]' --set "
               "outputs.snapshots=false --set outputs.report=false --out run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(text_of(folder / "run/events.csv"), "teleport_to");
  const std::string truth = text_of(folder / "run/truth.tum");
  const std::size_t after = truth.find("\n2.", truth.find("\n2.") + 1);
  ASSERT_NE(after, std::string::npos);
  std::istringstream line(truth.substr(after + 1));
  double stamp = 0.0;
  double x = 0.0;
  double y = 0.0;
  line >> stamp >> x >> y;
  EXPECT_NEAR(x, 2.0, 0.1);
  EXPECT_NEAR(y, 3.5, 0.1);
}

TEST(Run, MakesAWorldOfAnyRosMap) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "map lab --out lab/map.yaml").exit_code, 0);
  const Outcome outcome =
      castaway(folder,
               "run --world lab/map.yaml --duration 10 --set start=unknown --set "
               "events=[] --set outputs.snapshots=false --out run --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json mh_amcl = Json::parse(outcome.out).at("localizers").at("mh_amcl");
  EXPECT_EQ(mh_amcl.at("recovery").at("recovered"), 1);
}

TEST(Map, IsWhatIsCommittedBesideTheLab) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "map lab --out map.yaml").exit_code, 0);
  const fs::path lab = fs::path(CASTAWAY_SOURCE_DIR) / "worlds/lab";
  EXPECT_TRUE(text_of(folder / "map.pgm") == text_of(lab / "map.pgm"));
  EXPECT_EQ(text_of(folder / "map.yaml"), text_of(lab / "map.yaml"));
}

}  // namespace
}  // namespace castaway::test
