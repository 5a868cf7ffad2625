#include "tools/play/replay/recorded_maps.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "tools/build/map3d/file_volume.hpp"
#include "tools/build/map3d/ground_plan.hpp"
#include "tools/build/map3d/level_maps.hpp"
#include "tools/build/map3d/map3d_files.hpp"
#include "tools/scenario/files/bag_folder.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

using localization::MhAmcl3dConfig;

/// The voxels of a cloud are those of the first localizer that uses it.
Map3dOptions options_of(const std::vector<LocalizerSpec>& localizers) {
  Map3dOptions options;
  const auto first = std::ranges::find_if(localizers, is_on_map3d);
  if (first != localizers.end()) {
    options.resolution = std::get<MhAmcl3dConfig>(first->config).voxel;
  }
  return options;
}

std::shared_ptr<const Map3d> open_map3d(const ReplaySession& session) {
  return std::make_shared<const Map3d>(
      read_map3d_file(session.map3d, options_of(session.localizers)));
}

void require_none_on_planar_maps(const ReplaySession& session) {
  for (const LocalizerSpec& spec : session.localizers) {
    if (is_on_map3d(spec)) continue;
    throw std::invalid_argument("localizer '" + spec.name + "' works on a planar map, and " +
                                session.log +
                                " holds none: name one by --map, or leave the localizer out");
  }
}

}  // namespace

void check_maps(const ReplaySession& session) {
  if (is_map3d_source(session.map)) {
    throw std::invalid_argument(
        "--map " + session.map +
        ": is a 3-D map; name it by --map3d. --map takes a ROS map (.yaml)");
  }
  if (!session.map3d.empty()) require_map3d_source(session.map3d);
  if (session.map.empty() && session.map3d.empty() && !is_bag(session.log)) {
    throw std::invalid_argument("--map is missing: a CARMEN log holds no map");
  }
}

RecordedMaps open_maps(const ReplaySession& session, const std::optional<RosMap>& own,
                       const localization::WheelStance& wheels) {
  RecordedMaps maps;
  if (!session.map.empty()) {
    maps.planar = load_ros_map(session.map);
  } else if (own) {
    maps.planar = *own;
  } else if (session.map3d.empty()) {
    throw std::runtime_error(session.log +
                             ": holds no OccupancyGrid; name a map by --map, or --map3d");
  } else {
    require_none_on_planar_maps(session);
  }
  if (session.map3d.empty()) return maps;
  const std::shared_ptr<const Map3d> map3d = open_map3d(session);
  const std::filesystem::path file = session.map3d;
  if (maps.planar.cells.empty()) maps.planar = ground_plan(*map3d, file.stem().string());
  maps.levels = std::make_shared<const LevelMaps>(level_maps(map3d->ground));
  maps.volume = volume_of(file, map3d, wheels);
  return maps;
}

}  // namespace castaway::testbed
