#include "tools/scenario/files/bag_folder.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_ros1(const fs::path& path) {
  throw std::runtime_error(
      fmt::format("{}: is a bag of ROS 1; convert it to a ROS 2 bag first, e.g. by "
                  "rosbags-convert of the Python package rosbags",
                  path.string()));
}

/// Returns a readable file of a bag; throws for other formats.
fs::path require_bag_file(const fs::path& file) {
  if (file.extension() == ".bag") refuse_ros1(file);
  if (file.extension() == ".zstd" || file.extension() == ".zst") {
    throw std::runtime_error(
        fmt::format("{}: is compressed as a whole file; unpack it first: zstd -d {}", file.string(),
                    file.string()));
  }
  if (!fs::is_regular_file(file)) {
    throw std::runtime_error(fmt::format(
        "{}: cannot be read; check the path, and the names in metadata.yaml", file.string()));
  }
  return file;
}

std::vector<fs::path> files_of_metadata(const fs::path& folder) {
  YamlDocument document = YamlDocument::load(folder / "metadata.yaml");
  YamlReader root = document.root();
  YamlReader bag = root.child("rosbag2_bagfile_information");
  std::vector<fs::path> files;
  for (const auto& name : bag.require<std::vector<std::string>>("relative_file_paths")) {
    files.push_back(require_bag_file(folder / name));
  }
  return files;
}

std::vector<fs::path> files_by_name(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".mcap" || extension == ".db3") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool is_bag(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) || path.extension() == ".mcap" ||
         path.extension() == ".db3" || path.extension() == ".bag";
}

std::vector<fs::path> bag_files(const fs::path& path) {
  if (!fs::is_directory(path)) return {require_bag_file(path)};
  // A run folder holds its bag in a subfolder.
  const bool run = !fs::exists(path / "metadata.yaml") && fs::is_directory(path / "bag");
  const fs::path folder = run ? path / "bag" : path;
  const bool described = fs::exists(folder / "metadata.yaml");
  std::vector<fs::path> files = described ? files_of_metadata(folder) : files_by_name(folder);
  if (files.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: holds no .mcap or .db3 file; name a bag's folder or its file", folder.string()));
  }
  return files;
}

}  // namespace castaway::testbed
