// 3-D maps, held against octomap's own tools.
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// A deck over a floor, and a ramp that leads to it.
fs::path put_world(const fs::path& folder) {
  std::ofstream(folder / "deck.yaml") << "name: deck\nextent: {min: [-10, 0], max: [12, 8]}\n"
                                         "start: [0, 5, 0]\nobjects:\n"
                                         "  - box: {at: [9, 4], size: [6, 8, 0.2], bottom: 2.8}\n"
                                         "  - ramp: {at: [-1.5, 1], size: [15, 2, 3]}\n";
  return folder / "deck.yaml";
}

TEST(Map3d, SaysWhatItFound) {
  const fs::path folder = fresh_folder();
  put_world(folder);
  const Outcome outcome = castaway(folder, "map deck.yaml --out deck.map3d --picture levels.png");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, " MB in memory\nlevel 0 at 0.00 m: ");
  expect_contains(outcome.out, "level 1 at 3.00 m: ");
  expect_contains(text_of(folder / "levels.png"), "PNG");
  const std::string first = text_of(folder / "deck.map3d");
  EXPECT_EQ(castaway(folder, "map deck.map3d --out again.map3d").exit_code, 0);
  EXPECT_EQ(text_of(folder / "again.map3d"), first);
}

/// Occupied cells of a map made by `castaway map`, by their lower left corners in map [cells].
std::set<std::pair<int, int>> walls_of(const fs::path& yaml) {
  const auto number_after = [](const std::string& text, const std::string& key) {
    return std::stod(text.substr(text.find(key) + key.size()));
  };
  const std::string header = text_of(yaml);
  const double cell = number_after(header, "resolution: ");
  const std::string origin = header.substr(header.find("origin: [") + 9);
  const int left = static_cast<int>(std::lround(std::stod(origin) / cell));
  const int low = static_cast<int>(std::lround(number_after(origin, ", ") / cell));
  std::istringstream picture(text_of(fs::path(yaml).replace_extension(".pgm")));
  std::string magic;
  int width = 0;
  int height = 0;
  int white = 0;
  picture >> magic >> width >> height >> white;
  picture.get();
  std::set<std::pair<int, int>> walls;
  for (int row = height - 1; row >= 0; --row) {
    for (int column = 0; column < width; ++column) {
      if (picture.get() == 0) walls.emplace(left + column, low + row);
    }
  }
  return walls;
}

/// The share of cells that have one of the others within a cell.
double share_beside(const std::set<std::pair<int, int>>& cells,
                    const std::set<std::pair<int, int>>& others) {
  const auto is_beside = [&](const std::pair<int, int>& cell) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        if (others.contains({cell.first + dx, cell.second + dy})) return true;
      }
    }
    return false;
  };
  const auto beside = std::ranges::count_if(cells, is_beside);
  return static_cast<double>(beside) / static_cast<double>(cells.size());
}

TEST(Map3d, ItsCrossSectionIsThePlanarMapOfTheWorld) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "map lab --out lab.map3d --resolution 0.05").exit_code, 0);
  ASSERT_EQ(castaway(folder, "map lab --height 0.18 --out lab.yaml").exit_code, 0);
  const Outcome cut = castaway(folder, "map lab.map3d --height 0.18 --out cut.yaml");
  ASSERT_EQ(cut.exit_code, 0) << cut.err;
  expect_contains(cut.out, " cells of 0.05 m, cut at 0.180 m\n");
  const auto surveyed = walls_of(folder / "lab.yaml");
  const auto walls = walls_of(folder / "cut.yaml");
  EXPECT_GT(walls.size(), 500U);
  EXPECT_GT(share_beside(walls, surveyed), 0.99);
  const Outcome without = castaway(folder, "map lab.map3d --out none.yaml");
  EXPECT_EQ(without.exit_code, 2);
  expect_contains(without.err, "a 3-D map becomes a planar one by --height");
  EXPECT_FALSE(fs::exists(folder / "none.yaml"));
  const Outcome both = castaway(folder, "map lab --height 0.18 --out none.map3d");
  EXPECT_EQ(both.exit_code, 2);
  expect_contains(both.err, "--height is of planar maps: end --out in .yaml");
}

TEST(Map3d, OctomapsToolsReadItsFilesAndItReadsTheirs) {
  if (std::system("which convert_octree >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "octomap-tools are not installed";
  }
  const fs::path folder = fresh_folder();
  put_world(folder);
  const Outcome made = castaway(folder, "map deck.yaml --out deck.bt");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  const auto voxels_of = [](const std::string& out) {
    const std::size_t from = out.find(": ");
    return out.substr(from, out.find('\n') - from);
  };
  const std::string in_folder = "cd '" + folder.string() + "' && ";
  // Their .ot of our .bt, and their .bt of our .ot.
  ASSERT_EQ(std::system((in_folder + "convert_octree deck.bt theirs.ot >log 2>&1").c_str()), 0);
  ASSERT_EQ(castaway(folder, "map deck.bt --out ours.ot").exit_code, 0);
  ASSERT_EQ(std::system((in_folder + "convert_octree ours.ot theirs.bt >>log 2>&1").c_str()), 0);
  for (const std::string name : {"theirs.ot", "theirs.bt"}) {
    const Outcome read = castaway(folder, "map " + name + " --out from-" + name + ".map3d");
    EXPECT_EQ(read.exit_code, 0) << read.err;
    EXPECT_EQ(voxels_of(read.out), voxels_of(made.out)) << name;
  }
  EXPECT_EQ(text_of(folder / "theirs.bt"), text_of(folder / "deck.bt"));
}

using Json = nlohmann::json;

Json localizers_of(const fs::path& folder, const std::string& arguments) {
  const Outcome outcome =
      castaway(folder, "run " + arguments +
                           " --set outputs.snapshots=false --set outputs.report=false --out run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return Json::parse(text_of(folder / "run/summary.json")).at("localizers");
}

TEST(Map3d, OnAPlanarWorldMhAmclIsAsGoodAsOnAPlanarMap) {
  const Json both = localizers_of(
      fresh_folder(),
      "--duration 50 --set 'localizers=[mh_amcl, {mh_amcl: {mode: 3d, voxel: 0.05}}]'");
  const Json& planar = both.at("mh_amcl");
  const Json& volume = both.at("mh_amcl-3d");
  EXPECT_EQ(volume.at("recovery").at("recovered"), planar.at("recovery").at("recovered"));
  EXPECT_LE(volume.at("tracking_error_m").at("mean").get<double>(),
            1.1 * planar.at("tracking_error_m").at("mean").get<double>());
}

TEST(Map3d, OverRampsMhAmclIsRightOnA3dMapAlone) {
  const Json both = localizers_of(
      fresh_folder(), "hall/podium --duration 40 --localizer mh_amcl --localizer mh_amcl:3d");
  const auto mean = [&](const std::string& name) {
    return both.at(name).at("tracking_error_m").at("mean").get<double>();
  };
  EXPECT_GT(mean("mh_amcl"), 1.0);
  EXPECT_LT(mean("mh_amcl-3d"), 0.1);
}

TEST(Map3d, AReplayOnItIsTheRunToTheByte) {
  const fs::path folder = fresh_folder();
  localizers_of(folder, "mezzanine/kidnaps --duration 45 --set outputs.bag=true");
  ASSERT_EQ(castaway(folder, "map mezzanine --out mezzanine.map3d").exit_code, 0);
  const Outcome outcome = castaway(
      folder, "replay run --map3d mezzanine.map3d --start truth --no-pictures --out again");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const std::string name : {"mh_amcl-3d.tum", "truth.tum", "errors.csv", "events.csv"}) {
    EXPECT_GT(text_of(folder / "run" / name).size(), 200U);
    EXPECT_EQ(text_of(folder / "again" / name), text_of(folder / "run" / name)) << name;
  }
  const Outcome session = castaway(folder, "replay again/scenario.yaml --no-pictures --out thrice");
  ASSERT_EQ(session.exit_code, 0) << session.err;
  EXPECT_EQ(text_of(folder / "thrice/errors.csv"), text_of(folder / "run/errors.csv"));
}

TEST(Map3d, AReplayOfA3dLidarIsTheRunToTheByte) {
  const fs::path folder = fresh_folder();
  localizers_of(folder,
                "mezzanine/kidnaps --duration 24 --set 'lidar={profile: vlp-16}' --set "
                "outputs.bag=true --set 'localizers=[mh_amcl, {mh_amcl: {mode: 3d}}]'");
  ASSERT_EQ(castaway(folder, "map mezzanine --out mezzanine.map3d").exit_code, 0);
  const std::string common = " --start truth --no-pictures --localizer mh_amcl";
  const Outcome outcome = castaway(folder,
                                   "replay run --map3d mezzanine.map3d --imu-topic /imu"
                                   " --localizer mh_amcl:3d --out again" +
                                       common);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const std::string name : {"mh_amcl.tum", "mh_amcl-3d.tum", "truth.tum"}) {
    EXPECT_GT(text_of(folder / "run" / name).size(), 1000U);
    EXPECT_EQ(text_of(folder / "again" / name), text_of(folder / "run" / name)) << name;
  }
  ASSERT_EQ(castaway(folder, "replay run --imu-topic /imu --out planar" + common).exit_code, 0);
  EXPECT_EQ(text_of(folder / "planar/mh_amcl.tum"), text_of(folder / "run/mh_amcl.tum"));
}

TEST(Map3d, AReplayOnAnOctomapKnowsTheFloor) {
  const fs::path folder = fresh_folder();
  localizers_of(folder, "hall/podium --duration 40 --set outputs.bag=true --set imu=true");
  ASSERT_EQ(castaway(folder, "map hall --out hall.bt --resolution 0.05").exit_code, 0);
  const Outcome outcome = castaway(folder, "replay run --map3d hall.bt --no-pictures --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json localizer = Json::parse(outcome.out).at("localizers").at("mh_amcl-3d");
  EXPECT_LT(localizer.at("tracking_error_m").at("mean").get<double>(), 0.1);
}

/// A column of a run's errors.csv.
std::vector<double> column_of(const fs::path& run, const std::string& name) {
  std::istringstream lines(text_of(run / "errors.csv"));
  const auto cells = [&](const std::string& line) {
    std::vector<std::string> all;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) all.push_back(cell);
    return all;
  };
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = cells(line);
  const auto at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  std::vector<double> values;
  while (std::getline(lines, line)) values.push_back(std::stod(cells(line).at(at)));
  return values;
}

TEST(Map3d, OfThreeRampsThatLookAlikeEachIsStatedWithAboutAThird) {
  const fs::path folder = fresh_folder();
  localizers_of(folder, "car-park/ramps");
  const std::vector<double> stated = column_of(folder / "run", "probability");
  const std::vector<double> lost = column_of(folder / "run", "lost");
  ASSERT_GT(stated.size(), 150U);
  EXPECT_EQ(std::ranges::count(lost, 1.0), static_cast<std::ptrdiff_t>(lost.size()));
  double mean = 0.0;
  for (std::size_t i = 50; i < stated.size(); ++i) mean += stated[i];
  mean /= static_cast<double>(stated.size() - 50);
  EXPECT_NEAR(mean, 1.0 / 3.0, 0.12);
  EXPECT_LT(*std::ranges::max_element(stated), 0.6);
}

TEST(Map3d, ACarmenLogIsReplayedAtTheHeightThatIsStated) {
  const fs::path folder = fresh_folder();
  localizers_of(folder, "--duration 20 --set events=[] --set outputs.carmen=true");
  ASSERT_EQ(castaway(folder, "map lab --out lab.map3d").exit_code, 0);
  const auto error = [&](const std::string& more) {
    const Outcome outcome = castaway(folder,
                                     "replay run/log.carmen --map3d lab.map3d --no-pictures "
                                     "--start truth --json --out again --force " +
                                         more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json localizer = Json::parse(outcome.out).at("localizers").at("mh_amcl-3d");
    return localizer.at("tracking_error_m").at("mean").get<double>();
  };
  EXPECT_LT(error("--base-height 0.13"), 0.03);
  EXPECT_GT(error("--base-height 2.5"), 0.06);
  EXPECT_GT(error("--base-height 0.13 --truth-in-map 1,0,0"), 0.9);
}

TEST(Map3d, ARecordingOverFloorsIsEvaluatedOnIt) {
  const fs::path folder = fresh_folder();
  localizers_of(folder, "mezzanine/kidnaps --duration 60 --set outputs.bag=true");
  ASSERT_EQ(castaway(folder, "map mezzanine --out run/mezzanine.map3d").exit_code, 0);
  const std::string command =
      "evaluate run --starts 2 --kidnaps 2 --window 8 --kidnap-to near --json --localizer ";
  const Outcome outcome = castaway(folder, command + "mh_amcl:3d");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json row = Json::parse(outcome.out).at(0);
  EXPECT_GE(row.at("/starts/recovered"_json_pointer), 2);
  EXPECT_GE(row.at("/kidnaps/recovered"_json_pointer), 2);
  EXPECT_LT(row.at("tracking_m"), 0.03);
  fs::copy(folder / "run/mezzanine.map3d", folder / "run/another.map3d");
  expect_refused(castaway(folder, command + "mh_amcl:3d"), {"several 3-D maps", "--map3d"});
  const std::string named = command + "mh_amcl:3d --map3d run/another.map3d";
  const Outcome again = castaway(folder, named + " -j 2");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out).at(0).at("calibration"), row.at("calibration"));
  expect_refused(castaway(folder, named + " --add-boxes 0.1"), {"mh_amcl-3d", "planar maps only"});
  expect_refused(castaway(folder, command + "mh_amcl --map3d run/another.map3d"),
                 {"none of the localizers"});
  expect_refused(castaway(folder, command + "mh_amcl:3d --map3d gone.map3d"), {"gone.map3d"});
  expect_refused(castaway(folder, command + "mh_amcl:3d --map3d run/scenario.yaml"),
                 {"scenario.yaml", ".map3d"});
}

TEST(Map3d, ACarmenLogIsEvaluatedAtTheHeightThatIsStated) {
  const fs::path folder = fresh_folder();
  localizers_of(folder, "lab/kidnap --duration 15 --set outputs.carmen=true");
  ASSERT_EQ(castaway(folder, "map lab --out run/lab.map3d").exit_code, 0);
  const std::string command =
      "evaluate run --starts 1 --kidnaps 0 --window 5 --json --localizer mh_amcl:3d";
  expect_refused(castaway(folder, command), {"how high", "--base-height"});
  const auto error = [&](const std::string& more) {
    const Outcome outcome = castaway(folder, command + " --base-height 0.13" + more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out).at(0).at("tracking_m").get<double>();
  };
  EXPECT_LT(error(""), 0.03);
  EXPECT_GT(error(" --truth-in-map 1,0,0"), 0.9);
  expect_refused(castaway(folder, command + " --base-height 0.13 --truth-in-map 1,0"),
                 {"--truth-in-map"});
}

TEST(Map3d, AReplayNamesTheMapThatIsMissingOrInVain) {
  const fs::path folder = fresh_folder();
  put_world(folder);
  localizers_of(folder, "--duration 3 --set outputs.bag=true --set outputs.carmen=true");
  ASSERT_EQ(castaway(folder, "map deck.yaml --out deck.bt").exit_code, 0);
  const auto refused = [&](const std::string& arguments, const std::string& why) {
    expect_refused(castaway(folder, "replay " + arguments + " --out again"), {why});
  };
  refused("run --localizer mh_amcl:3d", "`castaway replay` takes one by --map3d");
  refused("run --map3d deck.bt --localizer amcl", "--map3d) is for mh_amcl in mode 3d");
  refused("run --map3d deck.yaml", "--map3d deck.yaml: a 3-D map is a .map3d, .bt");
  refused("run --map3d gone.bt", "gone.bt: cannot be read");
  refused("run --map deck.bt", "--map deck.bt: is a 3-D map; name it by --map3d");
  refused("run --base-height 0.1", "--base-height is for 3-D maps");
  refused("run/log.carmen --map3d deck.bt", "does not say how high its lidar is mounted");
}

TEST(Map3d, BadInputIsNamed) {
  const fs::path folder = fresh_folder();
  put_world(folder);
  std::ofstream(folder / "broken.bt") << "# Octomap OcTree binary file\n";
  expect_refused(castaway(folder, "map broken.bt --out x.map3d"), {"broken.bt", "data"});
  expect_refused(castaway(folder, "map missing.ply --out x.map3d"), {"missing.ply"});
  expect_refused(castaway(folder, "map deck.yaml --picture x.png"), {"--picture", ".map3d"});
  expect_refused(castaway(folder, "map broken.bt --out x.yaml"), {"--out", ".map3d"});
  ASSERT_EQ(castaway(folder, "map deck.yaml --out deck.bt").exit_code, 0);
  expect_refused(castaway(folder, "map deck.bt --resolution 0.2 --out y.bt"), {"--resolution"});
  std::ofstream(folder / "theirs.map3d") << "mine";
  expect_refused(castaway(folder, "map deck.yaml --out theirs.map3d"), {"theirs.map3d"});
  EXPECT_EQ(text_of(folder / "theirs.map3d"), "mine");
}

}  // namespace
}  // namespace castaway::test
