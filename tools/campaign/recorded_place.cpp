// Finding a log and its map in a folder.
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tools/campaign/evaluation.hpp"
#include "tools/run/carmen_source.hpp"
#include "tools/scenario/ros_map_file.hpp"

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

fs::path map_in(const fs::path& folder, const std::vector<fs::path>& files) {
  if (fs::exists(folder / "map.yaml")) return folder / "map.yaml";
  std::vector<fs::path> maps;
  std::copy_if(files.begin(), files.end(), std::back_inserter(maps),
               [](const fs::path& file) { return file.extension() == ".yaml"; });
  if (maps.size() == 1) return maps.front();
  throw std::runtime_error(folder.string() + ": no map; put a ROS map there as map.yaml");
}

}  // namespace

RecordedPlace load_recorded_place(const std::string& folder) {
  const std::vector<fs::path> files = files_in(folder);
  const auto log = std::find_if(files.begin(), files.end(), is_log);
  if (log == files.end()) {
    throw std::runtime_error(folder +
                             ": no log; put a CARMEN log there (*.log, *.carmen, also .gz)");
  }
  RecordedPlace place;
  place.map = load_ros_map(map_in(folder, files));
  fs::path name = fs::path(folder).filename();
  if (name.empty()) name = fs::path(folder).parent_path().filename();
  place.name = name.string();
  CarmenSource source(*log);
  while (auto frame = source.next()) place.frames.push_back(std::move(*frame));
  return place;
}

}  // namespace castaway::testbed
