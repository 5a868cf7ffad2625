// castaway map: writes the ROS map or the 3-D map of a world, and converts 3-D maps.
#include <memory>

#include <fmt/format.h>

#include "sim/map/rasterise.hpp"
#include "sim/robot/robot_sensors.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/base/formats/images/gray_image.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/say.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/build/build_world.hpp"
#include "tools/build/map3d/level_picture.hpp"
#include "tools/build/map3d/map3d_files.hpp"
#include "tools/build/map3d/map_slice.hpp"
#include "tools/build/map3d/survey_world.hpp"
#include "tools/build/sim_conversion.hpp"
#include "tools/commands/commands.hpp"
#include "tools/play/terminal.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct MapArguments {
  std::string world;
  std::string robot = "waffle";
  std::optional<double> height;
  std::optional<double> resolution;
  std::string out;
  std::string picture;
  std::optional<double> clearance;
  std::optional<double> max_slope;
  std::vector<std::string> search_paths;
  bool strict = false;
};

LoadedWorld load_world(const MapArguments& arguments, double height) {
  SurveyOptions options;
  options.lidar_height = height;
  options.strict = arguments.strict;
  LoadedWorld loaded = build_world({arguments.world, arguments.search_paths}, ".", options);
  for (const std::string& warning : loaded.warnings) {
    print_warning(warning);
  }
  return loaded;
}

Map3d map3d_of(const MapArguments& arguments) {
  Map3dOptions options;
  options.resolution = arguments.resolution.value_or(options.resolution);
  options.ground.clearance = arguments.clearance.value_or(options.ground.clearance);
  options.ground.max_slope = arguments.max_slope.value_or(options.ground.max_slope);
  if (is_map3d_source(arguments.world)) {
    if (arguments.resolution && is_map3d_target(arguments.world)) {
      throw std::invalid_argument("--resolution is of worlds and clouds: " + arguments.world +
                                  " keeps its voxels");
    }
    Map3d map = read_map3d_file(arguments.world, options);
    if (!arguments.clearance && !arguments.max_slope) return map;
    return survey_map3d(std::move(map.voxels), options);
  }
  const LoadedWorld world = load_world(arguments, SurveyOptions{}.lidar_height);
  const Eigen::Vector2d start = world.file.start.position();
  options.start = Eigen::Vector3d(start.x(), start.y(), 0.0);
  return survey_world(world.file.spec, options);
}

int make_map3d(const MapArguments& arguments) {
  if (arguments.height) {
    throw std::invalid_argument("--height is of planar maps: end --out in .yaml");
  }
  const std::filesystem::path out = arguments.out;
  require_own_file(out);
  if (!arguments.picture.empty()) require_own_file(arguments.picture);
  const Map3d map = map3d_of(arguments);
  write_own_file(out, encode_map3d_file(map, out));
  print_out("{}: {} voxels of {} m, {:.1f} MB in memory\n", out.string(), map.voxels.size(),
            map.voxels.resolution, static_cast<double>(map.voxels.bytes()) / 1e6);
  for (std::size_t level = 0; level < map.ground.levels.size(); ++level) {
    print_out("level {} at {:.2f} m: {:.0f} m2 drivable\n", level, map.ground.levels[level],
              drivable_area(map.ground, level));
  }
  if (arguments.picture.empty()) return kDone;
  write_own_file(arguments.picture, sim::encode_png(level_picture(map.ground)));
  print_out("{}\n", arguments.picture);
  return kDone;
}

/// Writes a planar map, whose picture goes beside it.
void write_map(const RosMap& map, const std::string& wanted, double height) {
  const std::filesystem::path out = wanted.empty()
                                        ? std::filesystem::path(file_name_of(map.name) + ".yaml")
                                        : std::filesystem::path(wanted);
  std::filesystem::path image = out;
  image.replace_extension(".pgm");
  require_own_file(out);
  write_own_file(image, encode_pgm(map_image(map)));
  write_own_file(out, ros_map_yaml(map, image.filename().string()));
  print_out("{}: {} x {} cells of {} m, cut at {:.3f} m\n", out.string(), map.width, map.height,
            map.resolution, height);
}

int make_slice(const MapArguments& arguments) {
  if (!arguments.height) {
    throw std::invalid_argument(
        "a 3-D map becomes a planar one by --height, that of the cross-section in the map [m], or "
        "a 3-D one by a name for --out that ends in .map3d, .bt or .ot");
  }
  const std::string name = std::filesystem::path(arguments.world).stem().string();
  write_map(map_slice(map3d_of(arguments), *arguments.height, name), arguments.out,
            *arguments.height);
  return kDone;
}

int make_map(const MapArguments& arguments) {
  if (is_map3d_target(arguments.out)) return make_map3d(arguments);
  if (!arguments.picture.empty()) {
    throw std::invalid_argument("--picture is of 3-D maps: end --out in .map3d, .bt or .ot");
  }
  if (is_map3d_source(arguments.world)) return make_slice(arguments);
  const double height = arguments.height
                            ? *arguments.height
                            : sim::lidar_of(build_robot({arguments.robot, {}, {}, {}}, "."))
                                  .T_base_laser.translation()
                                  .z();
  const LoadedWorld loaded = load_world(arguments, height);
  const WorldFile& world = loaded.file;
  const sim::Grid grid = sim::rasterise(world.spec, height, arguments.resolution.value_or(0.05));
  write_map(to_ros_map(grid, world.spec.name), arguments.out, height);
  return kDone;
}

}  // namespace

void add_map_command(Command& app) {
  auto a = std::make_shared<MapArguments>();
  Command command =
      app.add_command("map", "Survey a world into a ROS map (.yaml and .pgm), or a 3-D map");
  command
      .add_option("world", a->world,
                  "A world's name or path, or a 3-D map or cloud: .map3d, .bt, .ot, .pcd, .ply")
      .required();
  command.add_option("--robot", a->robot, "Robot whose lidar height is used").show_default();
  command
      .add_option(
          "--height", a->height,
          "Height of the survey [m], instead of a robot's lidar; of a 3-D map: height in it")
      .range(-1000.0, 1000.0);
  command
      .add_option("--resolution", a->resolution,
                  "Edge of a cell [m] (default: 0.05), or of a voxel (default: 0.1)")
      .range(0.005, 1.0);
  command
      .add_option("--clearance", a->clearance,
                  "3-D: least free height above the ground [m] (default: 1)")
      .range(0.05, 100.0);
  command
      .add_option("--max-slope", a->max_slope,
                  "3-D: steepest drivable slope, rise per metre (default: 0.35)")
      .range(0.001, 1.7);
  command.add_option("--picture", a->picture, "3-D: PNG file with the levels side by side");
  command.add_option(
      "--out", a->out,
      "File to write: .yaml (default: <world>.yaml; the picture goes beside it), or a 3-D "
      "map: .map3d, OctoMap's .bt or .ot");
  command
      .add_option("--search-path", a->search_paths,
                  "Folder in which models of an SDF world are searched")
      .repeatable();
  command.add_flag("--strict", a->strict, "Reject an SDF world if a part of it cannot be read");
  command.footer(
      "Examples:\n  castaway map lab --out worlds/lab/map.yaml\n"
      "  castaway map car-park --out car-park.bt --picture levels.png\n"
      "  castaway map corridor.bt --height 0.25 --out corridor.yaml");
  command.action([a] { return make_map(*a); });
}

}  // namespace castaway::testbed
