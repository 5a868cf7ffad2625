// No command replaces or removes a user's files, whatever output it is given.
#include <set>

#include "tests/program/dataset_files.hpp"

namespace castaway::test {
namespace {

/// A short run without pictures.
const std::string kTwoSeconds = "run --duration 2 --set outputs.snapshots=false";

std::string put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return text;
}

TEST(Output, AReplayNeverRemovesItsLog) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(
      castaway(folder, kTwoSeconds + " --set outputs.carmen=true --set outputs.map=true --out run")
          .exit_code,
      0);
  fs::copy(folder / "run/map", folder / "office");
  fs::copy(folder / "run/log.carmen", folder / "office/log.carmen");
  put(folder / "office/recording.gz", "mine");
  const auto before = files_of(folder / "office");
  for (const char* options : {"", " --force"}) {
    const Outcome outcome =
        castaway(folder, std::string("replay office/log.carmen --map office/map.yaml "
                                     "--no-pictures --out office") +
                             options);
    EXPECT_EQ(outcome.exit_code, 2);
    expect_contains(outcome.err,
                    "castaway: office: holds the input office/log.carmen; choose "
                    "another folder with --out");
  }
  EXPECT_EQ(files_of(folder / "office"), before);
}

TEST(Output, AReplayNeverRemovesItsBag) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(
      castaway(folder, kTwoSeconds + " --set outputs.bag=true --set outputs.map=true --out run")
          .exit_code,
      0);
  const auto before = files_of(folder / "run");
  const Outcome outcome =
      castaway(folder / "run", "replay bag --map map/map.yaml --no-pictures --out . 2>../err.txt");
  EXPECT_EQ(outcome.exit_code, 2);
  auto after = files_of(folder / "run");
  after.erase("stdout.txt");
  after.erase("stderr.txt");
  EXPECT_EQ(after, before);
}

/// A repository that ships a folder `runs` must not reach the user's files.
TEST(Output, AHiddenListNeverRemovesAFileOfTheUser) {
  const fs::path folder = fresh_folder();
  put(folder / "docs/thesis.tex", "mine");
  put(folder / "runs/lab-kidnap/seed-1/.castaway.json",
      R"({"castaway":"0.1.0","files":{"../../../docs/thesis.tex":null}})");
  const std::string run = "run --duration 1 --set 'events=[]' --set outputs.snapshots=false";
  EXPECT_EQ(castaway(folder, run).exit_code, 0);  // Writes to another folder.
  expect_refused(castaway(folder, run + " --force --out runs/lab-kidnap/seed-1"),
                 {"runs/lab-kidnap/seed-1/.castaway.json", "is not castaway's list"});
  EXPECT_EQ(text_of(folder / "docs/thesis.tex"), "mine");
}

/// Names of files need not be UTF-8; everything is written nevertheless.
TEST(Output, ANameThatIsNotUtf8LosesNothing) {
  const fs::path folder = folder_with_spec();
  const std::string scenario =
      "{world: room.yaml, duration_s: 1, physics: kinematic, events: [], outputs: {snapshots: "
      "false}, localizers: [amcl]}";
  put(folder / "caf\xe9.yaml", scenario);
  const Outcome outcome = castaway(folder, "run 'caf\xe9.yaml' --out 'r\xe9' --junit 'j\xe9.xml'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(text_of(folder / "r\xe9/summary.json"), "\"scenario\": \"caf_\"");
  EXPECT_TRUE(fs::exists(folder / "r\xe9/report.html"));
  EXPECT_TRUE(fs::exists(folder / "j\xe9.xml"));
  put(folder / "s.yaml", "name: caf\xe9\n");
  expect_refused(castaway(folder, "run s.yaml --out n"), {"s.yaml:1", "UTF-8"});
  EXPECT_FALSE(fs::exists(folder / "n"));
}

TEST(Output, ARunWithoutAScanIsDescribed) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "run --set stop_after_m=1e-6 --set outputs.snapshots=false --out run");
  EXPECT_EQ(outcome.err.find("json"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Output, AFullDiskFailsTheCommandInOneLine) {
  const fs::path folder = fresh_folder();
  for (const char* command : {"lidars", "settings"}) {
    const Outcome outcome =
        castaway(folder, std::string(command) + " >/dev/full 2>err.txt; echo $?");
    EXPECT_EQ(outcome.out, "1\n") << command << text_of(folder / "err.txt");
  }
}

TEST(Output, ARunKeepsFilesOfOthers) {
  const fs::path folder = fresh_folder();
  for (const char* file : {"bag/mine.mcap", "snapshots/mine.png", "recording.gz", "notes.txt"}) {
    const fs::path out = folder / "out";
    fs::remove_all(out);
    put(out / file, "mine");
    const Outcome refused = castaway(folder, kTwoSeconds + " --out out");
    EXPECT_EQ(refused.exit_code, 2);
    expect_contains(refused.err, std::string("out: holds '") + file +
                                     "', which castaway did not write; choose another folder");
    EXPECT_EQ(files_of(out).size(), 1U) << file;
    const Outcome forced =
        castaway(folder, kTwoSeconds + " --out out --force --set outputs.report=false");
    EXPECT_EQ(forced.exit_code, 0) << forced.err;
    EXPECT_EQ(text_of(out / file), "mine");
  }
}

TEST(Output, ARunLeavesNothingOfTheRunBefore) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(
      castaway(folder, kTwoSeconds + " --set people.count=1 --set outputs.kitti=true --out out")
          .exit_code,
      0);
  ASSERT_TRUE(fs::exists(folder / "out/people.csv"));
  ASSERT_TRUE(fs::exists(folder / "out/kitti"));
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --set localizers=[mh_amcl] --out out").exit_code, 0);
  for (const char* gone : {"people.csv", "kitti", "amcl.tum"}) {
    EXPECT_FALSE(fs::exists(folder / "out" / gone)) << gone;
  }
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --set localizers=[mh_amcl] --out fresh").exit_code, 0);
  EXPECT_EQ(files_of(folder / "out").size(), files_of(folder / "fresh").size());
}

TEST(Output, RunsWithOtherSettingsStandBesideEachOther) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds).exit_code, 0);
  const std::string first = text_of(folder / "runs/lab-kidnap/seed-1/scenario.yaml");
  const Outcome second = castaway(folder, kTwoSeconds + " --set lidar.range_max=6");
  ASSERT_EQ(second.exit_code, 0);
  expect_contains(second.err,
                  "runs/lab-kidnap/seed-1 holds something else; writing to "
                  "runs/lab-kidnap/seed-1-duration_s-2,outputs.snapshots-false,lidar.range_max-6");
  EXPECT_EQ(text_of(folder / "runs/lab-kidnap/seed-1/scenario.yaml"), first);
  const auto folders = [&] {
    return std::distance(fs::directory_iterator(folder / "runs/lab-kidnap"), {});
  };
  EXPECT_EQ(folders(), 2);
  ASSERT_EQ(castaway(folder, kTwoSeconds).exit_code, 0);
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --set lidar.range_max=6").exit_code, 0);
  EXPECT_EQ(folders(), 2);
}

TEST(Output, ARunIsNamedByItsRobotAndWorld) {
  const fs::path folder = fresh_folder();
  fs::create_directories(folder / "site");
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --set outputs.map=true --out made").exit_code, 0);
  fs::copy(folder / "made/map", folder / "site");
  const Outcome named =
      castaway(folder, kTwoSeconds + " --set events=[] --world site/map.yaml --robot butler");
  ASSERT_EQ(named.exit_code, 0) << named.err;
  expect_contains(named.out, "butler-on-map-kidnap, seed 1");
  EXPECT_TRUE(fs::exists(folder / "runs/butler-on-map-kidnap/seed-1/report.html"));
  const Outcome chosen = castaway(folder, kTwoSeconds + " --world office --name \"Hall 3\"");
  ASSERT_EQ(chosen.exit_code, 0) << chosen.err;
  EXPECT_TRUE(fs::exists(folder / "runs/Hall 3/seed-1/summary.json"));
  const Outcome refused = castaway(folder, "run --name a/b");
  EXPECT_EQ(refused.exit_code, 2);
  expect_contains(refused.err, "--name: must not hold '/'");
}

TEST(Output, ASavedScenarioIsPlayedIntoAnotherFolder) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds).exit_code, 0);
  const std::string run = "runs/lab-kidnap/seed-1";
  const auto before = files_of(folder / run);
  EXPECT_EQ(castaway(folder, "run " + run + "/scenario.yaml --out " + run).exit_code, 2);
  const Outcome again = castaway(folder, "run " + run + "/scenario.yaml");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(files_of(folder / run), before);
}

TEST(Output, ManySeedsKeepFilesOfOthers) {
  const fs::path folder = fresh_folder();
  put(folder / "out/seed-2/mine.txt", "mine");
  const Outcome outcome = castaway(folder, kTwoSeconds + " --seeds 2 --out out");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "out: holds 'seed-2/mine.txt'");
  EXPECT_FALSE(fs::exists(folder / "out/seed-1"));
}

TEST(Output, ManySeedsLeaveNoSeedOfAnEarlierCall) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --seeds 3 -j 2 --out out").exit_code, 0);
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --seeds 1 --out out").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/seed-1"));
  EXPECT_FALSE(fs::exists(folder / "out/seed-2"));
  EXPECT_FALSE(fs::exists(folder / "out/seed-3"));
}

TEST(Output, AComparisonKeepsFilesOfOthersAndItsInputs) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --out a").exit_code, 0);
  put(folder / "out/comparison.html", "mine");
  EXPECT_EQ(castaway(folder, "compare a a --out out").exit_code, 2);
  EXPECT_EQ(castaway(folder, "compare a a --out out --force").exit_code, 2);
  EXPECT_EQ(text_of(folder / "out/comparison.html"), "mine");
  expect_contains(castaway(folder, "compare a a --out a").err, "holds the input a");
  EXPECT_FALSE(fs::exists(folder / "a/comparison.html"));
}

TEST(Output, SingleFilesTakeNoPlaceOfOthers) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --out a").exit_code, 0);
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --out b").exit_code, 0);
  for (const char* name : {"x.yaml", "y.pgm", "x.xml", "x.html", "x.mp4", "w.png", "v-map.png"}) {
    put(folder / name, "mine");
  }
  for (const std::string& command :
       {std::string("map lab --out x.yaml"), std::string("map lab --out y.yaml"),
        kTwoSeconds + " --out c --junit x.xml", kTwoSeconds + " --out c --video x.mp4",
        kTwoSeconds + " --seeds 2 --out c --junit x.xml",
        std::string("experiment 1 --quick --out c --junit x.xml"),
        std::string("report a b --out x.html"), std::string("check-robot waffle --out w.png"),
        std::string("check-world lab --out w.png"), std::string("check-world lab --out v.png")}) {
    const Outcome outcome = castaway(folder, command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    expect_contains(outcome.err, ": exists, and castaway did not write it");
  }
  for (const char* name : {"x.yaml", "y.pgm", "x.xml", "x.html", "x.mp4", "w.png", "v-map.png"}) {
    EXPECT_EQ(text_of(folder / name), "mine") << name;
  }
  EXPECT_FALSE(fs::exists(folder / "c"));
  EXPECT_FALSE(fs::exists(folder / "y.yaml"));
  EXPECT_EQ(castaway(folder, "map lab --out z.yaml").exit_code, 0);
  EXPECT_EQ(castaway(folder, "map lab --out z.yaml").exit_code, 0);
}

TEST(Output, AReportReplacesNoPageOfOthers) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --out a --set outputs.report=false").exit_code, 0);
  put(folder / "a/report.html", "mine");
  EXPECT_EQ(castaway(folder, "report a").exit_code, 2);
  EXPECT_EQ(text_of(folder / "a/report.html"), "mine");
  fs::remove(folder / "a/report.html");
  EXPECT_EQ(castaway(folder, "report a").exit_code, 0);
  EXPECT_EQ(castaway(folder, "report a").exit_code, 0);
}

TEST(Output, ADataSetKeepsFilesOfOthers) {
  const fs::path folder = folder_with_spec();
  const fs::path out = folder / "out";
  put(out / "dataset.yaml", text_of(folder / "s.yaml"));
  for (const char* file : {"room.yaml", "room.pgm"}) fs::copy(folder / file, out / file);
  const auto before = files_of(out);
  EXPECT_EQ(castaway(folder, "dataset out/dataset.yaml -n 1 --out out").exit_code, 2);
  EXPECT_EQ(files_of(out), before);
  for (const char* file : {".work/mine", "sequences/mine", "dataset.yaml"}) {
    fs::remove_all(out);
    put(out / file, "mine");
    EXPECT_EQ(castaway(folder, "dataset s.yaml -n 1 --out out").exit_code, 2) << file;
    EXPECT_EQ(text_of(out / file), "mine");
  }
  put(folder / "two.work/mine", "mine");
  EXPECT_EQ(castaway(folder, "dataset s.yaml --only 0 --out two").exit_code, 0);
  EXPECT_EQ(text_of(folder / "two.work/mine"), "mine");
}

TEST(Output, ADataSetGrowsOnlyWhereItsCardIsItsOwn) {
  const fs::path folder = folder_with_spec();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 1 --out set").exit_code, 0);
  const std::string card = put(folder / "set/README.md", "mine");
  const Outcome outcome = castaway(folder, "dataset s.yaml -n 2 --out set");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "'README.md' was changed since castaway wrote it");
  EXPECT_EQ(text_of(folder / "set/README.md"), card);
}

// In files from others, names must be names and never paths.
TEST(Output, NamesFromFilesLeadNowhere) {
  const fs::path folder = fresh_folder();
  put(folder / "victim/report.html", "mine");
  const std::string bodies[] = {
      "name: ../../victim\nlocalizers: [mh_amcl]\n",
      "name: " + (folder / "victim").string() + "\nlocalizers: [mh_amcl]\n",
      "name: ..\nlocalizers: [mh_amcl]\n",
      "localizers: [{mh_amcl: {name: ../../victim/report.html}}]\n",
      "localizers: [{amcl: {name: /etc/amcl}}]\n",
      "localizers: [{amcl: {name: truth}}]\n",
      "localizers: [mh_amcl]\nlidars: [{../../victim/front: {beams: 36}}]\n",
      "localizers: [mh_amcl]\nworld: worlds/evil.yaml\n"};
  put(folder / "deep/down/worlds/evil.yaml",
      "name: ../../victim/evil\nextent: {min: [0, 0], max: [4, 4]}\nstart: [2, 2, 0]\n");
  for (const std::string& body : bodies) {
    put(folder / "deep/down/s.yaml", body + "duration_s: 1\noutputs: {snapshots: false}\n");
    const std::set<std::string> before = [&] {
      std::set<std::string> names;
      for (const auto& [name, text] : files_of(folder / "victim")) names.insert(name + text);
      return names;
    }();
    const Outcome outcome = castaway(folder / "deep/down", "run s.yaml");
    EXPECT_EQ(outcome.exit_code, 2) << body;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "deep/down/runs")) << body;
    EXPECT_EQ(files_of(folder / "victim").size(), before.size());
    EXPECT_EQ(text_of(folder / "victim/report.html"), "mine");
  }
  put(folder / "deep/down/s.yaml", "name: ../up\nscenario: {world: lab, localizers: [amcl]}\n");
  EXPECT_EQ(castaway(folder / "deep/down", "dataset s.yaml -n 1 --out set").exit_code, 2);
}

TEST(Output, ListsOfFilesAreTheSameForTheSameSeed) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --out a").exit_code, 0);
  ASSERT_EQ(castaway(folder, kTwoSeconds + " --out b").exit_code, 0);
  const std::string list = text_of(folder / "a/.castaway.json");
  EXPECT_NE(list, "");
  EXPECT_EQ(list, text_of(folder / "b/.castaway.json"));
}

}  // namespace
}  // namespace castaway::test
