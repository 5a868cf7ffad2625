// castaway check-robot: reports how a robot's description was interpreted.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/render/renderer.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/say.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/commands/arguments/robot_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/play/inspect/robot_report.hpp"
#include "tools/play/inspect/robot_scene.hpp"
#include "tools/play/terminal.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/sections/joint_states.hpp"

namespace castaway::testbed {
namespace {

constexpr int kWidth = 800;   // [px]
constexpr int kHeight = 600;  // [px]

/// Arguments of the command.
struct CheckArguments {
  RobotSpec robot;
  RobotArguments options;
  std::string joints;  ///< File of joint states; empty: all joints at 0.
  std::string out;
  bool json = false;
  bool expand = false;
  bool no_picture = false;
};

/// Writes a picture and returns its file name, or why there is none.
std::string take_picture(const sim::RobotModel& robot, const std::string& out) {
  std::string file = out.empty() ? file_name_of(robot.name) + ".png" : out;
  std::string png;
  try {
    png = sim::encode_png(sim::Renderer(kWidth, kHeight).render(robot_scene(robot)));
  } catch (const std::runtime_error& error) {
    return fmt::format("none: {}", error.what());
  }
  write_own_file(file, png);
  return file;
}

int print_expanded(const RobotSpec& spec) {
  const sim::ExpandedRobot expansion =
      sim::expand_robot(find_robot(spec.file, ".").string(), robot_options(spec, "."));
  print_out("{}", expansion.urdf);
  for (const std::string& warning : expansion.warnings) {
    print_warning(warning);
  }
  return kDone;
}

int check_robot(CheckArguments arguments) {
  for (const std::string& text : arguments.options.assignments) {
    arguments.robot.arguments.insert(parse_assignment(text));
  }
  arguments.robot.search_paths = arguments.options.search_paths;
  if (!arguments.joints.empty()) arguments.robot.joints = read_joint_states(arguments.joints);
  if (arguments.expand) return print_expanded(arguments.robot);
  const sim::RobotModel robot = build_robot(arguments.robot, ".");
  const std::string picture =
      arguments.no_picture ? "not asked for" : take_picture(robot, arguments.out);
  if (arguments.json) {
    auto json = robot_json(robot);
    json["picture"] = picture;
    print_out("{}\n", json_text(json, 2));
  } else {
    print_out("{}picture: {}\n", robot_text(robot), picture);
  }
  return kDone;
}

}  // namespace

void add_check_robot_command(Command& app) {
  auto a = std::make_shared<CheckArguments>();
  Command command = app.add_command("check-robot", "Show how a robot's description is interpreted");
  command.add_option("robot", a->robot.file, "A robot's name, a .urdf or a .xacro").required();
  add_robot_options(command, a->options);
  command.add_option("--joints", a->joints,
                     "File of joint positions, as `ros2 topic echo --once /joint_states` prints");
  command.add_option("--out", a->out, "Picture to write (default: <robot's name>.png)");
  command.add_flag("--no-picture", a->no_picture, "Write no picture");
  command.add_flag("--json", a->json, "Print JSON instead of words");
  command.add_flag("--expand", a->expand, "Print the URDF that xacro expands to, nothing else");
  command.footer(
      "Examples:\n"
      "  castaway check-robot my_robot.urdf\n"
      "  castaway check-robot my_robot.urdf.xacro --arg prefix:=a_ --search-path ~/ws/src");
  command.action([a] { return check_robot(*a); });
}

}  // namespace castaway::testbed
