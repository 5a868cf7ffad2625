#include "sim/stages/drive_stage.hpp"

#include <gtest/gtest.h>

#include "sim/stages/drive_space.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

TEST(DriveStage, CommandsTwentyTimesASecond) {
  const SimulationConfig config = test_simulation();
  Spaces spaces;
  DriveStage drive(config, spaces);
  PeopleStage nobody(config, spaces, config.start, {});
  int commands = 0;
  for (nanoseconds now{}; now < seconds(1); now += milliseconds(2)) {
    if (!drive.due(now)) continue;
    drive.command(now, config.start, nobody);
    ++commands;
  }
  EXPECT_EQ(commands, 20);
}

TEST(DriveStage, WaitsAsLongAsItIsTold) {
  SimulationConfig config = test_simulation();
  config.drive.wait_s = 2.0;
  Spaces spaces;
  DriveStage drive(config, spaces);
  PeopleStage nobody(config, spaces, config.start, {});
  EXPECT_EQ(drive.command(milliseconds(1999), config.start, nobody).v, 0.0);
  EXPECT_GT(drive.command(seconds(2), config.start, nobody).v, 0.0);
}

}  // namespace
}  // namespace castaway::sim
