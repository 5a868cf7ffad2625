// Finds a log and its map in a folder.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "tools/evaluate/evaluation.hpp"
#include "tools/metrics/void_run.hpp"
#include "tools/scenario/files/bag_folder.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/sources/bag/bag_reading.hpp"
#include "tools/sources/carmen_source.hpp"

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
  const bool itself = std::any_of(files.begin(), files.end(),
                                  [](const fs::path& file) { return file.extension() == ".mcap"; });
  if (itself) return folder;
  return fs::is_directory(folder / "bag") ? std::optional(folder / "bag") : std::nullopt;
}

[[noreturn]] void refuse_without_map(const fs::path& folder) {
  throw std::runtime_error(
      folder.string() +
      ": no map; put a ROS map there as map.yaml (castaway run --set outputs.map=true leaves one)");
}

void take_log(const fs::path& log, RecordedPlace& place) {
  CarmenSource source(log);
  while (auto frame = source.next()) place.frames.push_back(std::move(*frame));
}

/// Reads the bag. Its map is used only if there is no other.
void take_bag(const fs::path& path, bool has_map, RecordedPlace& place) {
  const BagInventory bag = take_inventory(path, bag_files(path));
  BagRecording recording = read_bag(bag, choose_topics(bag, {}));
  place.frames = std::move(recording.frames);
  if (has_map) return;
  if (!recording.map) refuse_without_map(path);
  place.map = std::move(*recording.map);
}

std::string last_part(const fs::path& folder) {
  return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

}  // namespace

RecordedPlace load_recorded_place(const std::string& folder) {
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
  const std::optional<fs::path> map = map_in(folder, files);
  if (map) place.map = load_ros_map(*map);
  if (map) place.map_file = map->string();
  if (!map && log != files.end()) refuse_without_map(folder);
  if (log != files.end()) {
    take_log(*log, place);
  } else {
    take_bag(*bag, map.has_value(), place);
  }
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
    take_bag(log, !map.empty(), place);
  } else if (map.empty()) {
    throw std::runtime_error(log + ": a CARMEN log has no map; give one with --map MAP.yaml");
  } else {
    take_log(log, place);
  }
  return place;
}

}  // namespace castaway::testbed
