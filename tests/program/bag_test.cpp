// Bags, CARMEN logs and maps of runs, read back by the program and by MRPT.
#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const std::string kBare = " --set outputs.snapshots=false --set outputs.report=false";
const std::string kNoPictures = " --no-pictures";
const std::string kReplay =
    " --start truth --seed 3 --localizer mh_amcl --localizer amcl --no-pictures --out again";

/// Simulates a kidnap run of 16 s with these settings into `run`.
void simulate(const fs::path& folder, const std::string& sets) {
  const Outcome outcome =
      castaway(folder,
               "run --duration 16 --seed 3 --set events.0.kidnap.at_s=5 --set people.count=3 --out "
               "run" +
                   kBare + sets);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

void expect_same_file(const fs::path& folder, const std::string& name) {
  const std::string text = text_of(folder / "run" / name);
  EXPECT_GT(text.size(), 1000U) << name;
  EXPECT_EQ(text_of(folder / "again" / name), text) << name;
}

TEST(Bag, ReplayedIsTheRunToTheByte) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true");
  const Outcome outcome = castaway(folder, "replay run" + kReplay);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* name : {"mh_amcl.tum", "amcl.tum", "truth.tum"}) {
    expect_same_file(folder, name);
  }
  const Json run = Json::parse(text_of(folder / "run" / "summary.json"));
  const Json again = Json::parse(text_of(folder / "again" / "summary.json"));
  for (const char* part : {"position_error_m", "recovery", "tracking_error_m"}) {
    EXPECT_EQ(again["localizers"]["mh_amcl"][part], run["localizers"]["mh_amcl"][part]) << part;
  }
}

TEST(Bag, OfAnUpsideDownAndATurnedLidarIsReplayedToTheByte) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "two.yaml")
      << "world: lab\nrobot: waffle\nlocalizers: [mh_amcl, amcl]\n"
         "events: [{kidnap: {at_s: 5}}]\n"
         "lidars:\n"
         "  - front: {profile: tim571, mount_xyz: [0.1, 0.02, 0.2], mount_rpy: [3.1415, 0, 0.3]}\n"
         "  - rear: {profile: lds-01, mount_xyz: [-0.1, 0, 0.2], mount_rpy: [0, 0, 2.7]}\n"
         "outputs: {bag: {compression: lz4}, snapshots: false, report: false}\n";
  const Outcome run = castaway(folder, "run two.yaml --duration 12 --seed 3 --out run");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Outcome outcome = castaway(folder, "replay run/bag" + kReplay);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_same_file(folder, "mh_amcl.tum");
  expect_same_file(folder, "amcl.tum");
}

TEST(Bag, IsReplayedWithLocalizersOfAFile) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true");
  std::ofstream(folder / "tuned.yaml")
      << "localizers:\n  - mh_amcl: {name: careful, stays: 0.99}\n  - amcl\n";
  std::ofstream(folder / "none.yaml") << "localizer: [amcl]\n";
  const std::string replay = "replay run --scans 40" + kNoPictures;
  const Outcome outcome = castaway(folder, replay + " --localizer tuned.yaml --out tuned");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string careful = text_of(folder / "tuned/careful.tum");
  EXPECT_GT(careful.size(), 1000U);
  EXPECT_TRUE(fs::exists(folder / "tuned/amcl.tum"));
  const Outcome repeated =
      castaway(folder, "replay tuned/scenario.yaml --out repeated" + kNoPictures);
  ASSERT_EQ(repeated.exit_code, 0) << repeated.err;
  EXPECT_EQ(text_of(folder / "repeated/careful.tum"), careful);
  expect_refused(castaway(folder, replay + " --localizer none.yaml --out no"),
                 {"none.yaml", "lists no localizer"});
}

TEST(Bag, IsSplicedAndItsSessionRepeatsThat) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true --set events=[]");
  const Outcome outcome = castaway(
      folder, "replay run/bag --splice 20:90 --from-scan 5 --scans 60 --out spliced" + kNoPictures);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string events = text_of(folder / "spliced/events.csv");
  expect_contains(events, "kidnap,splice");
  const Outcome again =
      castaway(folder, "replay spliced/scenario.yaml --out repeated" + kNoPictures);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(text_of(folder / "repeated/events.csv"), events);
  EXPECT_EQ(text_of(folder / "repeated/errors.csv"), text_of(folder / "spliced/errors.csv"));
  const Outcome both =
      castaway(folder, "replay spliced/scenario.yaml --seed 4 --out other" + kNoPictures);
  EXPECT_EQ(both.exit_code, 2);
  expect_contains(both.err, "states what is played; change it there, not by options");
}

TEST(Bag, OfAnEarlierRunIsReplacedOrRemoved) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true --set outputs.kitti=true");
  const std::string first = text_of(folder / "run" / "bag" / "lab_kidnap.mcap");
  simulate(folder, " --set outputs.bag=true --set outputs.kitti=true");
  EXPECT_EQ(text_of(folder / "run" / "bag" / "lab_kidnap.mcap"), first);
  simulate(folder, "");
  EXPECT_FALSE(fs::exists(folder / "run" / "bag"));
  EXPECT_FALSE(fs::exists(folder / "run" / "kitti"));
}

TEST(Bag, IsDescribed) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true");
  const Outcome words = castaway(folder, "bag run");
  EXPECT_EQ(words.exit_code, 0);
  expect_contains(words.out, "sensor_msgs/msg/LaserScan");
  expect_contains(words.out, "Metadata:  run: castaway ");
  expect_contains(words.out, ", world lab");
  EXPECT_EQ(words.out.find("outer-wall"), std::string::npos);  // Labels of all objects.
  EXPECT_LT(std::count(words.out.begin(), words.out.end(), '\n'), 30);
  const Outcome json = castaway(folder, "bag run/bag --json");
  const Json bag = Json::parse(json.out);
  std::uint64_t messages = 0;
  for (const Json& topic : bag["topics"]) messages += topic["messages"].get<std::uint64_t>();
  EXPECT_EQ(bag["messages"], messages);
  EXPECT_EQ(bag["attachments"].size(), 4U);
}

TEST(Bag, CutShortIsReplayedAsFarAsItGoes) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true");
  const std::string bytes = text_of(folder / "run" / "bag" / "lab_kidnap.mcap");
  std::ofstream(folder / "cut.mcap", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  const Outcome outcome = castaway(folder, "replay cut.mcap" + kReplay);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.err, "castaway: warning: cut.mcap: byte ");
  const std::string whole = text_of(folder / "run" / "amcl.tum");
  const std::string part = text_of(folder / "again" / "amcl.tum");
  EXPECT_GT(part.size(), whole.size() / 4);
  EXPECT_EQ(whole.substr(0, part.size()), part);
}

TEST(Bag, DamagedIsOneLineWithFileAndByte) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.bag=true");
  std::string bytes = text_of(folder / "run" / "bag" / "lab_kidnap.mcap");
  const std::size_t at = bytes.find("\x28\xB5\x2F\xFD") + 200;  // Inside a chunk, after zstd's
                                                                // magic.
  ASSERT_LT(at, bytes.size());
  bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
  std::ofstream(folder / "bad.mcap", std::ios::binary) << bytes;
  const Outcome outcome = castaway(folder, "replay bad.mcap");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "castaway: bad.mcap: byte ");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(Bag, RefusesWhatItCannotDoInOneLine) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "a.db3") << "SQLite format 3";
  std::ofstream(folder / "b.mcap") << "hello";
  const auto refused = [&](const std::string& arguments, const std::string& why) {
    const Outcome outcome = castaway(folder, arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    expect_contains(outcome.err, why);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused("replay a.db3", "a.db3: is no bag of ROS 2");
  refused("replay b.mcap", "b.mcap: is not an MCAP file");
  refused("replay gone.mcap", "gone.mcap: cannot be read");
  refused("replay b.mcap --use even", "--use takes CARMEN logs, not bags");
  refused("bag b.mcap", "b.mcap: is not an MCAP file");
  std::ofstream(folder / "some.log") << "";
  refused("replay some.log", "--map is missing");
  refused("replay gone.log", "gone.log: cannot be read");
  refused("run --set outputs.bag.compression=zip --out run", "'zip'");
}

/// If all beams of a scan have the same time, a CARMEN log holds the exact odometry and scans.
TEST(CarmenLog, ReplayedGivesTheSameEstimates) {
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.carmen=true --set outputs.map=true --set lidar.sweep=false");
  const Outcome outcome =
      castaway(folder, "replay run/log.carmen --map run/map/map.yaml" + kReplay);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_same_file(folder, "amcl.tum");
  expect_same_file(folder, "truth.tum");
}

TEST(CarmenLog, IsReadByMrpt) {
  if (std::system("command -v carmen2rawlog >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "carmen2rawlog is not installed (apt-get install mrpt-apps)";
  }
  const fs::path folder = fresh_folder();
  simulate(folder, " --set outputs.carmen=true");
  const std::string in_folder = "cd '" + folder.string() + "' && ";
  const std::string convert = "carmen2rawlog -q -w -i run/log.carmen -o out.rawlog >o.txt 2>&1";
  ASSERT_EQ(std::system((in_folder + convert).c_str()), 0) << text_of(folder / "o.txt");
  const std::string info = "rawlog-edit -i out.rawlog --info >info.txt 2>&1";
  ASSERT_EQ(std::system((in_folder + info).c_str()), 0);
  const std::string truth = text_of(folder / "run" / "truth.tum");
  const auto scans = std::count(truth.begin(), truth.end(), '\n');
  expect_contains(text_of(folder / "info.txt"), "ROBOTLASER1 /    " + std::to_string(scans) + " ");
}

}  // namespace
}  // namespace castaway::test
