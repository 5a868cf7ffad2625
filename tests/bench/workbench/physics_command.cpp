// workbench physics: compares a robot's drive with closed forms.
#include <memory>

#include <fmt/format.h>

#include "tests/bench/workbench/commands.hpp"
#include "tests/bench/workbench/physics_bench.hpp"
#include "tools/base/output/say.hpp"
#include "tools/build/build_robot.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct PhysicsArguments {
  std::string robot = "waffle";
  double physics_hz = 500.0;
};

int check_and_print(const PhysicsArguments& arguments) {
  RobotSpec spec;
  spec.file = arguments.robot;
  const auto checks = check_physics(build_robot(spec, "."), arguments.physics_hz);
  print_out("{:<38} {:>10} {:>12} {:>12}\n", arguments.robot, "expected", "measured", "error");
  for (const PhysicsCheck& check : checks) {
    print_out("{:<38} {:>10.3f} {:>12.6f} {:>12.6f} {}\n", check.what, check.expected,
              check.measured, check.measured - check.expected, check.unit);
  }
  return kDone;
}

}  // namespace

void add_physics_command(Command& app) {
  auto arguments = std::make_shared<PhysicsArguments>();
  Command command =
      app.add_command("physics", "Compare a robot's drive with closed-form mechanics");
  command.add_option("--robot", arguments->robot, "A robot's name, a .urdf or a .xacro");
  command.add_option("--physics-hz", arguments->physics_hz, "Steps a second").range(100.0, 10000.0);
  command.footer(
      "A straight line, a stop, a turn in place, an arc and a slope.\n"
      "Example:\n"
      "  build/release/workbench physics --robot butler");
  command.action([arguments] { return check_and_print(*arguments); });
}

}  // namespace castaway::testbed
