// Every command reports a void run as void and scores nobody by it.
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

/// A folder with a world in which bars enclose the start: they are at the height of the chassis and
/// too thin for the planner to see.
fs::path folder_with_cell() {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "cell.yaml") << R"(name: cell
extent: {min: [0, 0], max: [6, 4]}
start: [1, 1, 0]
objects:
  - wall: {points: [[0.1, 0.1], [5.9, 0.1], [5.9, 3.9], [0.1, 3.9]], closed: true}
  - box: {at: [1.45, 1], size: [0.05, 1, 0.02], bottom: 0.045, in_map: false}
  - box: {at: [0.5, 1], size: [0.05, 1, 0.02], bottom: 0.045, in_map: false}
  - box: {at: [1, 1.45], size: [1, 0.05, 0.02], bottom: 0.045, in_map: false}
  - box: {at: [1, 0.5], size: [1, 0.05, 0.02], bottom: 0.045, in_map: false}
routes: {out: [[1, 1], [4, 2]]}
)";
  std::ofstream(folder / "void.yaml") << R"(name: stuck-in-a-cell
world: cell.yaml
duration_s: 30
drive: {route: out}
localizers: [mh_amcl]
outputs: {snapshots: false}
)";
  return folder;
}

Json json_of(const fs::path& file) { return Json::parse(text_of(file)); }

TEST(Void, IsSaidByARunInAllThatItLeaves) {
  const fs::path folder = folder_with_cell();
  const Outcome outcome = castaway(folder, "run void.yaml --out a");
  EXPECT_EQ(outcome.exit_code, 1);
  expect_contains(outcome.out, "VOID: the robot");
  EXPECT_TRUE(json_of(folder / "a/summary.json").at("void").is_object());
  expect_contains(text_of(folder / "a/report.html"), "<strong>Void:</strong>");
  EXPECT_EQ(castaway(folder, "report a").exit_code, 0);
  expect_contains(text_of(folder / "a/report.html"), "<strong>Void:</strong>");
  EXPECT_EQ(castaway(folder, "run void.yaml --out b --junit b.xml").exit_code, 1);
  expect_contains(text_of(folder / "b.xml"), "void: the robot");
}

TEST(Void, MeetsNoExpectationOfACampaign) {
  const fs::path folder = folder_with_cell();
  std::ofstream(folder / "s.yaml")
      << "scenario: void.yaml\nseeds: 2\n"
         "expect: {mh_amcl.availability: \">= 0\", collisions: {is: \">= 0\", for: mean}}\n";
  const Outcome outcome = castaway(folder, "campaign s.yaml --out c -j 2");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  expect_contains(outcome.out, "not scored: 2 void, 0 failed");
  expect_contains(outcome.out, "not met: mh_amcl.availability has nothing to measure");
  expect_contains(outcome.out, "not met: collisions has nothing to measure");
}

TEST(Void, IsLeftOutOfTheSeeds) {
  const fs::path folder = folder_with_cell();
  const Outcome outcome = castaway(folder, "run void.yaml --seeds 2 --out a --junit a.xml");
  EXPECT_EQ(outcome.exit_code, 1);
  expect_contains(outcome.out + outcome.err, "2 void (seeds 1, 2) and left out");
  const Json summary = json_of(folder / "a/summary.json");
  EXPECT_EQ(summary.at("void_seeds"), Json({1, 2}));
  EXPECT_TRUE(summary.at("seeds").empty());
  EXPECT_TRUE(summary.at("failed_seeds").empty());
  expect_contains(text_of(folder / "a.xml"), "void: the robot");
}

/// Data of castaway in which the lab is replaced by that world.
fs::path data_with_cell(const fs::path& folder) {
  const fs::path data = folder / "data";
  fs::create_directories(data / "worlds");
  for (const char* kind : {"robots", "lidars"}) {
    fs::create_directory_symlink(fs::path(CASTAWAY_SOURCE_DIR) / kind, data / kind);
  }
  std::string world = text_of(folder / "cell.yaml");
  const std::string way = ": [[1, 1], [4, 2]]";
  world.insert(world.rfind('}'), ", loop" + way + ", workshop" + way + ", loop-back" + way +
                                     ", workshop-back" + way + ", both" + way);
  write(data / "worlds/lab/world.yaml", world);
  std::string scenario = text_of(folder / "void.yaml");
  scenario.replace(scenario.find("cell.yaml"), 9, "lab");
  write(data / "worlds/lab/scenarios/paper-tracking.yaml", scenario);
  return data;
}

TEST(Void, IsLeftOutOfAnExperiment) {
  const fs::path folder = folder_with_cell();
  const std::string data = "CASTAWAY_DATA=" + data_with_cell(folder).string();
  const Outcome outcome = castaway(folder, "experiment 1 --out e --junit e.xml", data);
  EXPECT_EQ(outcome.exit_code, 1);
  expect_contains(outcome.err, "e/runs/both/seed-1: void, and left out: the robot");
  expect_contains(outcome.err, "no run of the experiment counts: see e");
  EXPECT_FALSE(fs::exists(folder / "e/summary.json"));
  const std::string junit = text_of(folder / "e.xml");
  expect_contains(junit, "errors=\"5\"");
  expect_contains(junit, "void: the robot");
}

TEST(Void, IsComparedAndEvaluatedByNobody) {
  const fs::path folder = folder_with_cell();
  ASSERT_EQ(castaway(folder, "run void.yaml --out a").exit_code, 1);
  const Outcome compared = castaway(folder, "compare a a --out c");
  EXPECT_NE(compared.exit_code, 0);
  expect_contains(compared.out + compared.err, "void");
  const Outcome evaluated = castaway(folder, "evaluate a");
  EXPECT_NE(evaluated.exit_code, 0);
  expect_contains(evaluated.out + evaluated.err, "void");
}

/// Writes a hall divided by such bars into squares of 1 m, which no robot can leave.
void write_grid(const fs::path& file) {
  std::ofstream out(file);
  out << "name: grid\nextent: {min: [0, 0], max: [12, 8]}\nstart: [1.5, 1.5, 0]\nobjects:\n"
         "  - wall: {points: [[0.1, 0.1], [11.9, 0.1], [11.9, 7.9], [0.1, 7.9]], closed: true}\n";
  const auto bar = [&](double x, double y, double length, double width) {
    out << fmt::format(
        "  - box: {{at: [{}, {}], size: [{}, {}, 0.02], bottom: 0.045, in_map: false}}\n", x, y,
        length, width);
  };
  for (int x = 1; x < 12; ++x) bar(x, 4.0, 0.05, 7.8);
  for (int y = 1; y < 8; ++y) bar(6.0, y, 11.8, 0.05);
}

TEST(Void, IsLeftOutOfABenchOfKidnaps) {
  const fs::path folder = fresh_folder();
  write_grid(folder / "grid.yaml");
  const Outcome outcome = castaway(
      folder,
      "bench kidnaps --world grid.yaml --kidnaps 3 --window 20 --lead 10 --localizer mh_amcl");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  expect_contains(outcome.out, "3 trials are void and left out");
  EXPECT_EQ(outcome.out.find(" of 3"), std::string::npos);
}

TEST(Void, LeavesADatasetUnfinished) {
  const fs::path folder = folder_with_cell();
  std::ofstream(folder / "s.yaml") << R"(name: stuck
license: CC0-1.0
scenario: {world: cell.yaml, duration_s: 30, drive: {route: out}}
)";
  const Outcome outcome = castaway(folder, "dataset s.yaml --out d -n 1");
  EXPECT_EQ(outcome.exit_code, 1);
  expect_contains(outcome.err, "its run is void: the robot");
  EXPECT_FALSE(fs::exists(folder / "d/manifest.json"));
}

}  // namespace
}  // namespace castaway::test
