// castaway map: writes the ROS map of a world.
#include <memory>

#include <fmt/format.h>

#include "sim/map/rasterise.hpp"
#include "sim/robot/robot_sensors.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/commands/commands.hpp"
#include "tools/formats/images/gray_image.hpp"
#include "tools/output/file_name.hpp"
#include "tools/output/own_file.hpp"
#include "tools/sources/build_robot.hpp"
#include "tools/sources/build_world.hpp"
#include "tools/sources/sim_conversion.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct MapArguments {
  std::string world;
  std::string robot = "waffle";
  std::optional<double> height;
  double resolution = 0.05;
  std::string out;
  std::vector<std::string> search_paths;
  bool strict = false;
};

int make_map(const MapArguments& arguments) {
  const double height = arguments.height
                            ? *arguments.height
                            : sim::lidar_of(build_robot({arguments.robot, {}, {}, {}}, "."))
                                  .T_base_laser.translation()
                                  .z();
  SurveyOptions options;
  options.lidar_height = height;
  options.strict = arguments.strict;
  const LoadedWorld loaded = build_world({arguments.world, arguments.search_paths}, ".", options);
  for (const std::string& warning : loaded.warnings) {
    fmt::print(stderr, "castaway: warning: {}\n", warning);
  }
  const WorldFile& world = loaded.file;
  const sim::Grid grid = sim::rasterise(world.spec, height, arguments.resolution);
  const std::filesystem::path out =
      arguments.out.empty() ? std::filesystem::path(file_name_of(world.spec.name) + ".yaml")
                            : std::filesystem::path(arguments.out);
  const RosMap map = to_ros_map(grid, world.spec.name);
  std::filesystem::path image = out;
  image.replace_extension(".pgm");
  require_own_file(out);
  write_own_file(image, encode_pgm(map_image(map)));
  write_own_file(out, ros_map_yaml(map, image.filename().string()));
  fmt::print("{}: {} x {} cells of {} m, cut at {:.3f} m\n", out.string(), grid.width, grid.height,
             grid.resolution, height);
  return kDone;
}

}  // namespace

void add_map_command(Command& app) {
  auto a = std::make_shared<MapArguments>();
  Command command = app.add_command("map", "Survey a world into a ROS map (.yaml and .pgm)");
  command.add_option("world", a->world, "A world's name or path").required();
  command.add_option("--robot", a->robot, "Robot whose lidar height is used").show_default();
  command.add_option("--height", a->height, "Height of the survey [m], instead of a robot's lidar")
      .range(-1000.0, 1000.0);
  command.add_option("--resolution", a->resolution, "Edge of a cell [m]")
      .show_default()
      .range(0.005, 1.0);
  command.add_option("--out", a->out,
                     "YAML file to write (default: <world>.yaml); the picture goes beside it");
  command
      .add_option("--search-path", a->search_paths,
                  "Folder in which models of an SDF world are searched")
      .repeatable();
  command.add_flag("--strict", a->strict, "Reject an SDF world if a part of it cannot be read");
  command.footer("Example:\n  castaway map lab --out worlds/lab/map.yaml");
  command.action([a] { return make_map(*a); });
}

}  // namespace castaway::testbed
