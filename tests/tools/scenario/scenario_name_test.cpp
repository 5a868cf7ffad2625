#include "tools/scenario/scenario_name.hpp"

#include <gtest/gtest.h>

#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

std::optional<std::string> name_of_kidnap(const std::vector<std::string>& overrides) {
  return name_of_overridden(data_root() / "worlds/lab/scenarios/kidnap.yaml", overrides);
}

TEST(ScenarioName, IsMadeOfRobotWorldAndScenario) {
  EXPECT_EQ(name_of_kidnap({"world=map.yaml", "robot='burger.urdf'"}), "burger-on-map-kidnap");
  EXPECT_EQ(name_of_kidnap({"world=/sites/hall 3.sdf.xacro"}), "hall 3-kidnap");
  EXPECT_EQ(name_of_kidnap({"robot={file: 'my/bot.urdf.xacro', args: {a: 'b'}}"}),
            "bot-on-lab-kidnap");
  EXPECT_EQ(name_of_kidnap({"world.name=office"}), "office-kidnap");
  EXPECT_EQ(name_of_kidnap({"robot.file=butler"}), "butler-on-lab-kidnap");
}

TEST(ScenarioName, NamesModelsOfGazeboByTheirFolders) {
  EXPECT_EQ(name_of_kidnap({"robot='models/turtlebot/model.sdf'"}), "turtlebot-on-lab-kidnap");
}

TEST(ScenarioName, KeepsTheNameOfTheSameWorldAndRobot) {
  EXPECT_EQ(name_of_kidnap({}), std::nullopt);
  EXPECT_EQ(name_of_kidnap({"seed=7", "lidar.range_max=6", "world=lab"}), std::nullopt);
  EXPECT_EQ(name_of_kidnap({"world.levels=false"}), std::nullopt);
}

TEST(ScenarioName, KeepsANameThatIsSet) {
  EXPECT_EQ(name_of_kidnap({"world=map.yaml", "name=mine"}), std::nullopt);
}

TEST(ScenarioName, KeepsAScenarioNameThatDoesNotBeginWithItsWorld) {
  EXPECT_EQ(name_of_overridden(data_root() / "worlds/lab/scenarios/paper-recovery.yaml",
                               {"world=office"}),
            "office-paper-recovery");
}

TEST(ScenarioLabel, TellsWhatWasSet) {
  EXPECT_EQ(label_of({"duration_s=60", "people.count=8"}), "duration_s-60,people.count-8");
  EXPECT_EQ(label_of({"amcl:amcl-prob"}), "amcl-amcl-prob");
  EXPECT_EQ(label_of({}), "");
}

TEST(ScenarioLabel, LeavesAwayWhatAShellNeedsQuotesFor) {
  EXPECT_EQ(label_of({"events=[]"}), "");
  EXPECT_EQ(label_of({"events=[]", "seed=2"}), "seed-2");
  EXPECT_EQ(label_of({"drive.path=../a"}), "");
}

TEST(ScenarioLabel, IsEmptyWhereItIsLong) {
  EXPECT_EQ(label_of({std::string(61, 'a')}), "");
  EXPECT_EQ(label_of({std::string(60, 'a')}).size(), 60U);
}

}  // namespace
}  // namespace castaway::testbed
