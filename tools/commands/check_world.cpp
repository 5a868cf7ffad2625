// castaway check-world: reports how a world was interpreted.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "sim/render/renderer.hpp"
#include "sim/robot/robot_sensors.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/say.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/commands/commands.hpp"
#include "tools/play/inspect/world_report.hpp"
#include "tools/play/inspect/world_scene.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

constexpr int kWorldPictureWidth = 1000;  // [px]
constexpr int kWorldPictureHeight = 750;  // [px]

/// Arguments of the command.
struct CheckWorldArguments {
  WorldChoice world;
  std::string robot = "waffle";
  std::string scenario;
  double range_max = 12.0;
  std::uint64_t seed = 1;
  std::string out;
  bool json = false;
  bool no_picture = false;
  bool strict = false;
};

std::string map_name(const std::string& file) {
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "-map.png")).string();
}

/// Writes two pictures and returns their file names, or why there are none.
std::string take_pictures(const LoadedWorld& world, const std::string& out) {
  const std::string file = out.empty() ? file_name_of(world.file.spec.name) + ".png" : out;
  std::string overview;
  std::string map;
  try {
    sim::Renderer renderer(kWorldPictureWidth, kWorldPictureHeight);
    overview = sim::encode_png(renderer.render(world_scene(world)));
    map = sim::encode_png(renderer.render(world_map_scene(world)));
  } catch (const std::runtime_error& error) {
    return fmt::format("none: {}", error.what());
  }
  require_own_file(map_name(file));
  write_own_file(file, overview);
  write_own_file(map_name(file), map);
  return fmt::format("{}, {}", file, map_name(file));
}

/// Takes world, seed and differences from a scenario.
void take_scenario(CheckWorldArguments& arguments) {
  arguments.scenario = find_scenario(arguments.scenario, ".").string();
  const LoadedScenario loaded = load_scenario(arguments.scenario, {});
  arguments.world = loaded.scenario.world;
  arguments.seed = loaded.scenario.seed;
}

int check_world(CheckWorldArguments arguments) {
  std::filesystem::path base = ".";
  if (!arguments.scenario.empty()) {
    take_scenario(arguments);
    base = std::filesystem::path(arguments.scenario).parent_path();
  }
  const sim::RobotModel robot = build_robot({arguments.robot, {}, {}, {}}, ".");
  const double height = sim::lidar_of(robot).T_base_laser.translation().z();
  SurveyOptions options;
  options.lidar_height = height;
  options.robot_radius = robot.footprint_radius;
  options.strict = arguments.strict;
  options.seed = arguments.seed;
  const LoadedWorld world = build_world(arguments.world, base, options);
  const WorldFacts facts = world_facts(world, {height, arguments.range_max});
  const std::string pictures =
      arguments.no_picture ? "not asked for" : take_pictures(world, arguments.out);
  if (arguments.json) {
    auto json = world_json(world, facts);
    json["pictures"] = pictures;
    print_out("{}\n", json_text(json, 2));
  } else {
    print_out("{}pictures: {}\n", world_text(world, facts), pictures);
  }
  return kDone;
}

}  // namespace

void add_check_world_command(Command& app) {
  auto a = std::make_shared<CheckWorldArguments>();
  Command command = app.add_command(
      "check-world", "Show how a world is interpreted and how hard it is to localize in");
  command.add_option("world", a->world.file, "A world's name or file (YAML, .sdf, .world, ROS map)")
      .show_default();
  command.add_option("--scenario", a->scenario,
                     "Scenario whose world is checked, with its seed and its differences");
  command
      .add_option("--search-path", a->world.search_paths,
                  "Folder in which models of an SDF world are searched (besides "
                  "GZ_SIM_RESOURCE_PATH, GAZEBO_MODEL_PATH, SDF_PATH)")
      .repeatable();
  command.add_option("--robot", a->robot, "Robot whose lidar height is used").show_default();
  command.add_option("--range-max", a->range_max, "Of the lidar that sees places alike [m]")
      .show_default()
      .range(0.5, 200.0);
  command.add_option("--out", a->out,
                     "Picture to write (default: <world's name>.png); the map's goes beside it");
  command.add_flag("--no-picture", a->no_picture, "Write no pictures");
  command.add_flag("--strict", a->strict, "Reject an SDF world if a part of it cannot be read");
  command.add_flag("--json", a->json, "Print JSON instead of words");
  command.footer(
      "Examples:\n"
      "  castaway check-world office\n"
      "  castaway check-world my_world.sdf --search-path ~/models --out my_world.png\n"
      "  castaway check-world --scenario worlds/lab/scenarios/moved.yaml --no-picture");
  command.action([a] { return check_world(*a); });
}

}  // namespace castaway::testbed
