#include "tools/scenario/data_paths.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> folders_in(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(path, none)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// What to look for: `<data>/<kind>s/<text>/<one of files>`.
fs::path find(const std::string& kind, const std::string& text, const fs::path& base,
              const std::vector<std::string>& files) {
  const fs::path shipped = data_root() / (kind + "s");
  for (const fs::path& candidate : {fs::path(text), base / text, shipped / text}) {
    if (text.empty()) break;
    if (fs::is_regular_file(candidate)) return candidate;
    for (const std::string& file : files) {
      if (fs::is_regular_file(candidate / file)) return candidate / file;
    }
  }
  throw std::runtime_error(fmt::format("{} '{}' not found: give a path, or one of: {}", kind, text,
                                       fmt::join(folders_in(shipped), ", ")));
}

}  // namespace

fs::path data_root() {
  const char* root = std::getenv("CASTAWAY_DATA");
  return root != nullptr ? fs::path(root) : fs::path(CASTAWAY_SOURCE_DIR);
}

fs::path find_world(const std::string& text, const fs::path& base) {
  return find("world", text, base, {"world.yaml"});
}

fs::path find_robot(const std::string& text, const fs::path& base) {
  const std::string name = fs::path(text).filename().string();
  return find("robot", text, base, {name + ".urdf", name + ".urdf.xacro", name + ".xacro"});
}

}  // namespace castaway::testbed
