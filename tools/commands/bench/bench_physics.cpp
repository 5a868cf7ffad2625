// castaway bench physics: compares a robot's drive with closed forms.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/bench/physics_bench.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/commands/bench/bench.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct PhysicsArguments {
  std::string robot = "waffle";
  double physics_hz = 500.0;
  bool json = false;
};

int bench_physics(const PhysicsArguments& arguments) {
  RobotSpec spec;
  spec.file = arguments.robot;
  const auto checks = check_physics(build_robot(spec, "."), arguments.physics_hz);
  if (arguments.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PhysicsCheck& check : checks) {
      list.push_back({{"what", check.what},
                      {"unit", check.unit},
                      {"expected", check.expected},
                      {"measured", check.measured}});
    }
    print_out("{}\n", json_text(list, 1));
    return kDone;
  }
  print_out("{:<38} {:>10} {:>12} {:>12}\n", arguments.robot, "expected", "measured", "error");
  for (const PhysicsCheck& check : checks) {
    print_out("{:<38} {:>10.3f} {:>12.6f} {:>12.6f} {}\n", check.what, check.expected,
              check.measured, check.measured - check.expected, check.unit);
  }
  return kDone;
}

}  // namespace

void add_bench_physics(Command& bench) {
  auto arguments = std::make_shared<PhysicsArguments>();
  Command command =
      bench.add_command("physics", "Compare a robot's drive with closed-form mechanics");
  command.add_option("--robot", arguments->robot, "A robot's name, a .urdf or a .xacro");
  command.add_option("--physics-hz", arguments->physics_hz, "Steps a second").range(100.0, 10000.0);
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "A straight line, a stop, a turn in place, an arc and a slope.\n"
      "Example:\n"
      "  castaway bench physics --robot butler");
  command.action([arguments] { return bench_physics(*arguments); });
}

}  // namespace castaway::testbed
