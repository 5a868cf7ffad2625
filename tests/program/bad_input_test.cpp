// Bad input gives one clear line and a non-zero exit code, and existing files are kept.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

const char* const kUrdf = R"(<robot name="box"><link name="base_link">
  <inertial><mass value="1"/><inertia ixx=".01" iyy=".01" izz=".01" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual><origin xyz="0 0 0.1"/><geometry><mesh filename="gone.stl"/></geometry></visual>
  <collision><origin xyz="0 0 0.1"/><geometry><box size="0.2 0.2 0.1"/></geometry></collision></link>
)";
const char* const kWheels = R"(
  <link name="left"><inertial><mass value="0.1"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.05" length="0.02"/></geometry></collision></link>
  <link name="right"><inertial><mass value="0.1"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.05" length="0.02"/></geometry></collision></link>
  <joint name="left_joint" type="continuous"><parent link="base_link"/><child link="left"/><origin xyz="0 0.12 0.05"/><axis xyz="0 1 0"/></joint>
  <joint name="right_joint" type="continuous"><parent link="base_link"/><child link="right"/><origin xyz="0 -0.12 0.05"/><axis xyz="0 1 0"/></joint>
)";

TEST(BadInput, MissingScenario) {
  expect_refused(castaway(fresh_folder(), "run gone.yaml"), {"gone.yaml"});
}

TEST(BadInput, MalformedYaml) {
  const fs::path folder = fresh_folder();
  write(folder / "a.yaml", "seed: 1\nlocalizers: [mh_amcl\nworld: lab\n");
  expect_refused(castaway(folder, "run a.yaml"), {"a.yaml:3"});
}

TEST(BadInput, UnknownKey) {
  const fs::path folder = fresh_folder();
  write(folder / "a.yaml", "localizers: [mh_amcl]\nduratoin_s: 4\n");
  expect_refused(castaway(folder, "run a.yaml"), {"a.yaml:2", "duratoin_s", "duration_s"});
  expect_refused(castaway(folder, "run --set drive.rout=loop"), {"drive.rout", "route"});
}

TEST(BadInput, UnknownWorldRobotAndRoute) {
  const fs::path folder = fresh_folder();
  expect_refused(castaway(folder, "run --world atlantis"), {"atlantis", "lab"});
  expect_refused(castaway(folder, "run --robot r2d2"), {"r2d2", "waffle"});
  expect_refused(castaway(folder, "run --set drive.route=lop"), {"lop", "loop"});
}

TEST(BadInput, FolderOfDataThatHoldsNone) {
  const fs::path folder = fresh_folder();
  for (const char* command : {"run", "run lab/kidnap", "scenarios", "lidars"}) {
    expect_refused(castaway(folder, command, "CASTAWAY_DATA=/nowhere"),
                   {"/nowhere", "CASTAWAY_DATA"});
  }
}

TEST(BadInput, UrdfWithoutWheels) {
  const fs::path folder = fresh_folder();
  write(folder / "sled.urdf", std::string(kUrdf) + "</robot>");
  expect_refused(castaway(folder, "run --robot sled.urdf"), {"sled.urdf", "wheel"});
}

TEST(BadInput, UrdfThatIsNoXml) {
  const fs::path folder = fresh_folder();
  write(folder / "torn.urdf", "<robot name=\"torn\"><link");
  expect_refused(castaway(folder, "check-robot torn.urdf"), {"torn.urdf"});
}

TEST(BadInput, MissingMeshIsAWarningAndABoundingShape) {
  const fs::path folder = fresh_folder();
  write(folder / "box.urdf", std::string(kUrdf) + kWheels + "</robot>");
  const Outcome outcome = castaway(folder, "check-robot box.urdf");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "gone.stl");
  const Outcome run = castaway(
      folder,
      "run --robot box.urdf --duration 2 --set events=[] --set outputs.snapshots=false --out r");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  expect_contains(run.err, "gone.stl");
}

TEST(BadInput, MapWithoutOrWithHalfAnImage) {
  const fs::path folder = fresh_folder();
  write(folder / "map.yaml",
        "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: "
        "0.65\nfree_thresh: 0.196\n");
  expect_refused(castaway(folder, "run --world map.yaml"), {"map.pgm"});
  write(folder / "map.pgm", "P5\n10 10\n255\nabc");
  expect_refused(castaway(folder, "run --world map.yaml"), {"map.pgm"});
}

TEST(BadInput, BrokenLineOfALog) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "map lab --out map.yaml").exit_code, 0);
  write(folder / "a.log", "ODOM 0 0 0 0 0 0 0 h 0\nFLASER 180 1 2 three\n");
  expect_refused(castaway(folder, "replay a.log --map map.yaml"), {"a.log:2"});
  expect_refused(castaway(folder, "replay gone.log --map map.yaml"), {"gone.log"});
}

TEST(BadInput, OutputFolderThatCannotBeWritten) {
  const fs::path folder = fresh_folder();
  write(folder / "taken", "a file where the folder should be");
  expect_refused(castaway(folder, "run --duration 1 --set events=[] --out taken/run"), {"taken"});
  EXPECT_EQ(text_of(folder / "taken"), "a file where the folder should be");
}

TEST(BadInput, KidnapThatHasNoPlaceSoFarAwayTakesTheFarthest) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder,
                                   "run --duration 3 --set events.0.kidnap.at_s=1 --set "
                                   "events.0.kidnap.min_distance_m=500 --out run");
  EXPECT_EQ(outcome.exit_code, 0);
  expect_contains(outcome.err, "min_distance_m");
  expect_contains(outcome.err, "it goes to the farthest");
}

TEST(BadInput, CommandLineThatMakesNoSense) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, "").exit_code, 2);
  EXPECT_EQ(castaway(folder, "rum").exit_code, 2);
  EXPECT_EQ(castaway(folder, "replay").exit_code, 2);
  expect_refused(castaway(folder, "run --seed minus"), {"seed"});
  EXPECT_EQ(castaway(folder, "run --help").exit_code, 0);
}

TEST(NoEgl, TheRunGoesOnWithoutPicturesAndSaysSo) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "run --duration 3 --set events.0.kidnap.at_s=1 --out run",
               "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent EGL_PLATFORM=none");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.err, "pictures");
  EXPECT_TRUE(fs::exists(folder / "run/summary.json"));
  EXPECT_TRUE(fs::exists(folder / "run/snapshots/none.txt"));
  for (const auto& entry : fs::directory_iterator(folder / "run/snapshots")) {
    EXPECT_NE(entry.path().extension(), ".png");
  }
  expect_contains(text_of(folder / "run/report.html"), "EGL");
}

}  // namespace
}  // namespace castaway::test
