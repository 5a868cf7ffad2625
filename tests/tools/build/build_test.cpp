#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/tools/support/arm_robot.hpp"
#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kBareRobot = R"(<robot name="bare">
<link name="base"><collision><origin xyz="0 0 0.08"/><geometry><box size="0.3 0.2 0.1"/></geometry>
</collision><inertial><mass value="4"/><inertia ixx="0.05" iyy="0.05" izz="0.05" ixy="0" ixz="0"
iyz="0"/></inertial></link>
<link name="l"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
<link name="r"><collision><geometry><sphere radius="0.05"/></geometry></collision></link>
<joint name="lj" type="continuous"><parent link="base"/><child link="l"/><origin xyz="0 0.12 0.05"/>
<axis xyz="0 1 0"/></joint>
<joint name="rj" type="continuous"><parent link="base"/><child link="r"/>
<origin xyz="0 -0.12 0.05"/><axis xyz="0 1 0"/></joint></robot>)";

TEST(BuildLocalizers, MakesOneForEachSpecification) {
  const std::vector<LocalizerSpec> specs = {{"a", localization::MhAmclConfig{}},
                                            {"b", localization::AmclConfig{}}};
  const auto localizers = build_localizers(specs, {office_map()}, 1);
  ASSERT_EQ(localizers.size(), 2U);
  EXPECT_EQ(localizers[0].name, "a");
  EXPECT_EQ(localizers[1].localizer->diagnostics().populations.at(0).particles.size(), 2000U);
}

TEST(BuildLocalizers, TakesTheLocalizerOfTheProgramAroundCastaway) {
  Greeting told;
  const OwnConfig own{[&told](const Greeting& greeting) {
    told = greeting;
    return std::make_unique<localization::Amcl>(localization::AmclConfig{},
                                                to_occupancy_grid(greeting.map), greeting.seed);
  }};
  const auto localizers = build_localizers({{"mine", own}}, {office_map()}, 7);
  EXPECT_EQ(localizers.front().name, "mine");
  EXPECT_NE(localizers.front().localizer, nullptr);
  EXPECT_EQ(told.name, "mine");
  EXPECT_EQ(told.seed, localizer_seed(7, "mine"));
}

TEST(BuildLocalizers, RefusesALocalizerOfAProgramThatIsNotThere) {
  try {
    build_localizers({{"mine", OwnConfig{}}}, {office_map()}, 1);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "localizer 'mine': is an object of the program that made the run: castaway.run "
                 "takes it, in Python, or castaway::run, in C++");
  }
}

TEST(LocalizerFactory, BuildsWhatBuildLocalizersBuilds) {
  const std::vector<LocalizerSpec> specs = {{"a", localization::MhAmclConfig{}},
                                            {"b", localization::AmclConfig{}}};
  std::vector<NamedLocalizer> shared;  // Outlives the factory.
  {
    const LocalizerFactory factory(specs, {office_map()});
    (void)factory.build(3);  // Leaves nothing behind in the models.
    shared = factory.build(4);
  }
  std::vector<NamedLocalizer> own = build_localizers(specs, {office_map()}, 4);
  for (auto* localizers : {&shared, &own}) {
    for (NamedLocalizer& named : *localizers) {
      named.localizer->initialize(localization::PoseWithCovariance{
          {2.0, 2.0, 0.1}, Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal()});
    }
  }
  ASSERT_EQ(shared.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(shared[i].name, own[i].name);
    EXPECT_EQ(shared[i].localizer->diagnostics().populations.at(0).particles,
              own[i].localizer->diagnostics().populations.at(0).particles);
  }
}

TEST(BuildLocalizers, SayWhenTheMapIsOfNoUse) {
  EXPECT_THROW((void)build_localizers({{"a", localization::AmclConfig{}}}, {}, 1),
               std::invalid_argument);
}

TEST(ToOccupancyGrid, ReadsOccupancyAsNav2Does) {
  const RosMap map{"m", 5, 1, 0.1, 1.0, 2.0, 0.3, {0, 19, 40, 65, -1}};
  const localization::OccupancyGrid grid = to_occupancy_grid(map);
  using localization::CellState;
  EXPECT_EQ(grid.cells,
            (std::vector<CellState>{CellState::kFree, CellState::kFree, CellState::kUnknown,
                                    CellState::kOccupied, CellState::kUnknown}));
  EXPECT_EQ(grid.frame.T_map_grid, (SE2{1.0, 2.0, 0.3}));
}

TEST(BuildSimulation, PullsUpAMapThatItIsHanded) {
  RosMap map{"box", 60, 40, 0.05, 0.0, 0.0, 0.0, std::vector<std::int8_t>(60 * 40, 0)};
  map.cells[0] = 100;
  Scenario scenario;
  scenario.world.file = "nowhere";
  scenario.drive.route = "none";
  const PreparedSimulation prepared = build_simulation(scenario, ".", map);
  EXPECT_EQ(prepared.world_name, "box");
  EXPECT_EQ(prepared.map.cells, map.cells);
  EXPECT_EQ(prepared.config.world.objects.size(), 1U);
  EXPECT_TRUE(prepared.config.random_start);
}

/// Warnings for the waffle with wheel joints limited to this speed.
std::vector<std::string> warnings_with_wheels_of(const std::string& rad_per_s) {
  std::string urdf = read_file(find_robot("waffle", "."));
  const std::string shipped = "velocity=\"8.06\"";
  for (auto at = urdf.find(shipped); at != std::string::npos; at = urdf.find(shipped, at + 1)) {
    urdf.replace(at, shipped.size(), "velocity=\"" + rad_per_s + "\"");
  }
  const TemporaryFolder folder;
  Scenario scenario;
  scenario.robot.file = folder.put("slow.urdf", urdf).string();
  scenario.drive.route = "none";
  return build_simulation(scenario, ".").warnings;
}

TEST(BuildSimulation, WarnsOfWheelsThatAreMuchSlowerThanTheDrive) {
  const auto slows = [](const std::string& warning) {
    return contains(warning, "<limit velocity> of the wheels' joints slows the robot down to 0.10");
  };
  const auto warnings = warnings_with_wheels_of("3.03");
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), slows), 1);
  const auto fast = warnings_with_wheels_of("8.06");
  EXPECT_TRUE(std::none_of(fast.begin(), fast.end(), [](const std::string& warning) {
    return contains(warning, "<limit velocity>");
  }));
}

/// Like joint_controller of gz-sim: the world is as small as its only object.
TEST(BuildSimulation, SaysThatTheRobotFitsNowhere) {
  const TemporaryFolder folder;
  folder.put("small.sdf",
             "<sdf version='1.6'><world name='w'><model name='m'><static>1</static><pose>0 0 0.2 0 "
             "0 0</pose><link name='l'><collision name='c'><geometry><box><size>0.4 0.4 0.4</size>"
             "</box></geometry></collision></link></model></world></sdf>");
  Scenario scenario;
  scenario.world.file = "small.sdf";
  EXPECT_TRUE(contains(error_of([&] { (void)build_simulation(scenario, folder.path()); }),
                       "world w has no place where the robot, 0.2"));
}

TEST(BuildSimulation, WarnsOfARobotThatIsWiderThanItsRoute) {
  const TemporaryFolder folder;
  Scenario scenario;
  scenario.world.file = "lab";
  const auto tight = [&](const std::string& robot) {
    scenario.robot.file = robot;
    const auto warnings = build_simulation(scenario, ".").warnings;
    return std::count_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.find("has no room at") != std::string::npos;
    });
  };
  EXPECT_EQ(tight(folder.put("arm.urdf", waffle_with_arm()).string()), 1);
  EXPECT_EQ(tight("waffle"), 0);
}

/// Warnings for a robot whose file describes no lidar.
std::string warnings_without_lidar(const std::optional<Eigen::Vector3d>& mount) {
  const TemporaryFolder folder;
  Scenario scenario;
  scenario.robot.file = folder.put("bare.urdf", kBareRobot).string();
  scenario.drive.route = "none";
  if (mount) scenario.lidars.front().set("mount_xyz", *mount);
  RosMap map{"box", 60, 40, 0.05, 0.0, 0.0, 0.0, std::vector<std::int8_t>(60 * 40, 0)};
  std::string text;
  for (const std::string& line : build_simulation(scenario, ".", map).warnings) text += line + "\n";
  return text;
}

TEST(BuildSimulation, SaysWhereARobotWithoutLidarGetsOne) {
  EXPECT_TRUE(contains(warnings_without_lidar({}),
                       "no lidar: one is put at (0.00, 0.00, 0.20) m, free of the body"));
  EXPECT_TRUE(contains(warnings_without_lidar(Eigen::Vector3d(0.0, 0.0, 0.08)),
                       "at (0.00, 0.00, 0.08) m, not free of the body"));
  EXPECT_FALSE(contains(warnings_without_lidar(Eigen::Vector3d(0.5, 0.0, 0.08)), "not free"));
}

TEST(CpuClock, GoesForwardWhileThereIsWork) {
  const std::chrono::nanoseconds begin = thread_cpu_time();
  volatile double sum = 0.0;
  for (int i = 0; i < 2000000; ++i) sum = sum + 1.0;
  EXPECT_GT(thread_cpu_time(), begin);
  EXPECT_GE(wall_time(), std::chrono::nanoseconds(1));
}

TEST(DataPaths, FindWhatIsShippedByName) {
  EXPECT_EQ(find_world("lab", ".").filename(), "world.yaml");
  EXPECT_EQ(find_robot("waffle", ".").filename(), "waffle.urdf");
  EXPECT_THROW((void)find_world("", "."), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
