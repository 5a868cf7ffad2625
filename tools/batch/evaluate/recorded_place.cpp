#include "tools/batch/evaluate/recorded_place.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "tools/build/bag/bag_reading.hpp"
#include "tools/build/map3d/file_volume.hpp"
#include "tools/build/map3d/map3d_files.hpp"
#include "tools/build/recorded/carmen_source.hpp"
#include "tools/build/recorded/truth_frame.hpp"
#include "tools/run/metrics/void_run.hpp"
#include "tools/scenario/files/bag_folder.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

bool is_log(const fs::path& path) {
  std::string name = path.filename().string();
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  return name == "log" || name.ends_with(".log") || name.ends_with(".carmen") ||
         name.ends_with(".clf");
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) files.push_back(entry.path());
  if (error) throw std::runtime_error(folder.string() + ": cannot be read: " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

/// The map beside a log: map.yaml, map/map.yaml of a run folder, or the only YAML file. Nothing if
/// there is none.
std::optional<fs::path> map_in(const fs::path& folder, const std::vector<fs::path>& files) {
  for (const char* name : {"map.yaml", "map/map.yaml"}) {
    if (fs::exists(folder / name)) return folder / name;
  }
  std::vector<fs::path> maps;
  std::copy_if(files.begin(), files.end(), std::back_inserter(maps), [](const fs::path& file) {
    const std::string name = file.filename().string();
    return file.extension() == ".yaml" && name != "scenario.yaml" && name != "metadata.yaml";
  });
  return maps.size() == 1 ? std::optional(maps.front()) : std::nullopt;
}

/// The bag in a folder: the folder itself, or `bag` of a run folder. Nothing if there is none.
std::optional<fs::path> bag_in(const fs::path& folder, const std::vector<fs::path>& files) {
  const bool itself = std::any_of(files.begin(), files.end(), [](const fs::path& file) {
    return file.extension() == ".mcap" || file.extension() == ".db3";
  });
  if (itself) return folder;
  return fs::is_directory(folder / "bag") ? std::optional(folder / "bag") : std::nullopt;
}

[[noreturn]] void refuse_without_map(const fs::path& folder) {
  throw std::runtime_error(
      folder.string() +
      ": no map; put a ROS map there as map.yaml (castaway run --set outputs.map=true leaves one)");
}

void take_log(const fs::path& log, const PlaceMaps& maps, RecordedPlace& place) {
  CarmenSourceConfig config;
  if (maps.map3d) config.lidar_height = stated_lidar_height(maps.map3d->base_height);
  CarmenSource source(log, config);
  while (auto frame = source.next()) place.frames.push_back(std::move(*frame));
}

/// Reads the bag. Its map is used only if there is no other. Returns how its robot stands.
localization::WheelStance take_bag(const fs::path& path, const PlaceMaps& maps,
                                   RecordedPlace& place) {
  const BagInventory bag = take_inventory(path, bag_files(path));
  BagTopicOptions topics;
  topics.in_space = maps.map3d.has_value();
  const BagGround ground{topics.in_space, maps.map3d ? maps.map3d->base_height : std::nullopt};
  BagRecording recording = read_bag(bag, choose_topics(bag, topics), ground);
  place.frames = std::move(recording.frames);
  place.warnings = std::move(recording.warnings);
  if (place.map.cells.empty() && recording.map) place.map = std::move(*recording.map);
  return std::move(recording.wheels);
}

/// The only file of a 3-D map in the folder.
fs::path map3d_in(const fs::path& folder, const std::vector<fs::path>& files) {
  std::vector<fs::path> maps;
  std::copy_if(files.begin(), files.end(), std::back_inserter(maps), is_map3d_source);
  if (maps.size() == 1) return maps.front();
  if (maps.empty()) {
    throw std::runtime_error(folder.string() +
                             ": no 3-D map; put a .map3d, .bt, .ot, .pcd or .ply file there, or "
                             "name one by --map3d (castaway map WORLD --out map.map3d makes one)");
  }
  throw std::runtime_error(folder.string() + ": several 3-D maps (" + maps[0].filename().string() +
                           ", " + maps[1].filename().string() + "); name one by --map3d");
}

void take_map3d(const fs::path& file, const localization::WheelStance& wheels,
                RecordedPlace& place) {
  auto map = std::make_shared<const Map3d>(read_map3d_file(file, {}));
  place.volume = volume_of(file, std::move(map), wheels);
}

std::string last_part(const fs::path& folder) {
  return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

}  // namespace

PlaceMaps maps_for(const std::vector<LocalizerSpec>& localizers, const Map3dOfPlace& map3d) {
  if (!map3d.file.empty()) require_map3d_source(map3d.file);
  const auto in_3d = std::ranges::count_if(localizers, is_on_map3d);
  PlaceMaps maps;
  maps.planar = in_3d < std::ssize(localizers);
  if (in_3d > 0) maps.map3d = map3d;
  if (in_3d == 0 && (!map3d.file.empty() || map3d.base_height)) {
    throw std::invalid_argument(
        "--map3d and --base-height are for mh_amcl in mode 3d, and none of the localizers is: add "
        "mh_amcl:3d, or leave them out");
  }
  return maps;
}

RecordedPlace load_recorded_place(const std::string& folder, const PlaceMaps& maps) {
  if (fs::exists(fs::path(folder) / "summary.json")) {
    if (const auto reason = void_sentence_of(folder)) {
      throw std::runtime_error(folder + ": its run is void: " + *reason);
    }
  }
  const std::vector<fs::path> files = files_in(folder);
  const auto log = std::find_if(files.begin(), files.end(), is_log);
  const std::optional<fs::path> bag = bag_in(folder, files);
  if (log == files.end() && !bag) {
    throw std::runtime_error(
        folder +
        ": no log; put a CARMEN log (*.log, *.carmen, also .gz) or a bag there "
        "(castaway run --set outputs.carmen=true leaves one)");
  }
  RecordedPlace place;
  const std::optional<fs::path> map = maps.planar ? map_in(folder, files) : std::nullopt;
  if (map) place.map = load_ros_map(*map);
  if (map) place.map_file = map->string();
  fs::path map3d = maps.map3d ? maps.map3d->file : "";
  if (maps.map3d && map3d.empty()) map3d = map3d_in(folder, files);
  if (maps.planar && !map && log != files.end()) refuse_without_map(folder);
  localization::WheelStance wheels;
  if (log != files.end()) {
    take_log(*log, maps, place);
  } else {
    wheels = take_bag(*bag, maps, place);
  }
  if (maps.map3d) take_map3d(map3d, wheels, place);
  if (maps.planar && place.map.cells.empty()) refuse_without_map(folder);
  move_truth(place.frames, maps.T_map_truth);
  place.name = last_part(folder);
  return place;
}

RecordedPlace load_recorded_log(const std::string& log, const std::string& map) {
  if (!fs::exists(log)) throw std::runtime_error(log + ": no such file");
  RecordedPlace place;
  place.name = fs::path(log).filename().string();
  if (!map.empty()) place.map = load_ros_map(map);
  place.map_file = map;
  if (is_bag(log)) {
    take_bag(log, {}, place);
    if (place.map.cells.empty()) refuse_without_map(log);
  } else if (map.empty()) {
    throw std::runtime_error(log + ": a CARMEN log has no map; give one with --map MAP.yaml");
  } else {
    take_log(log, {}, place);
  }
  return place;
}

}  // namespace castaway::testbed
