#include "sim/world/sdf/resource_finder.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "xacro/files/lower_case.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

/// `uri` without its scheme.
std::string path_of(const std::string& uri) {
  const std::size_t scheme = uri.find("://");
  if (scheme == std::string::npos) return uri;
  const std::string name = uri.substr(0, scheme);
  if (name == "model" || name == "package" || name == "file") return uri.substr(scheme + 3);
  throw ResourceMissing(
      uri, "is not on this machine; download it and name its folder in `search_paths`");
}

std::vector<std::string> folders_of_environment() {
  std::vector<std::string> folders;
  for (const char* name :
       {"GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH"}) {
    const char* value = std::getenv(name);
    std::istringstream list(value == nullptr ? "" : value);
    for (std::string folder; std::getline(list, folder, ':');) {
      if (!folder.empty()) folders.push_back(folder);
    }
  }
  return folders;
}

/// The entry of a folder with this name, ignoring case.
std::optional<fs::path> entry_in(const fs::path& folder, const std::string& name) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string there = entry.path().filename().string();
    if (to_lower(there) == to_lower(name)) found.push_back(entry.path());
  }
  if (found.empty()) return std::nullopt;
  return *std::min_element(found.begin(), found.end());
}

/// The file or folder with its links resolved; nothing if it does not exist.
std::optional<fs::path> find_existing(const fs::path& path, bool any_case) {
  std::error_code none;
  const fs::path exact = fs::weakly_canonical(path, none);
  if (none) return std::nullopt;
  if (!any_case) return fs::exists(exact) ? std::optional(exact) : std::nullopt;
  fs::path found;
  for (const fs::path& part : exact) {
    const fs::path next = found / part;
    if (fs::exists(next)) {
      found = next;
    } else if (const auto entry = entry_in(found, part.string())) {
      found = *entry;
    } else {
      return std::nullopt;
    }
  }
  return fs::canonical(found);
}

}  // namespace

ResourceFinder::ResourceFinder(const fs::path& world,
                               const std::vector<std::string>& search_paths) {
  const fs::path folder = fs::absolute(world).parent_path();
  std::vector<fs::path> wanted{folder, folder / "models", folder.parent_path() / "models",
                               folder.parent_path().parent_path() / "models"};
  wanted.insert(wanted.end(), search_paths.begin(), search_paths.end());
  for (const std::string& path : folders_of_environment()) wanted.emplace_back(path);
  for (const fs::path& path : wanted) {
    if (fs::is_directory(path)) folders_.push_back(fs::canonical(path));
  }
  // Paths such as `file://models/chair/chair.dae` start where the world's package lies.
  starts_ = folders_;
  const fs::path above = folder.parent_path();
  for (const fs::path& path : {above, above.parent_path()}) {
    if (fs::is_directory(path)) starts_.push_back(fs::canonical(path));
  }
}

bool ResourceFinder::may_read(const fs::path& path) const {
  return std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
  });
}

fs::path ResourceFinder::find(const std::string& uri, const fs::path& from) const {
  const fs::path path = path_of(uri);
  bool outside = false;
  std::vector<fs::path> starts{from};
  starts.insert(starts.end(), starts_.begin(), starts_.end());
  for (const bool any_case : {false, true}) {
    for (const fs::path& start : starts) {
      const auto candidate = find_existing(start / path, any_case);
      if (path.empty() || !candidate) continue;
      if (may_read(*candidate)) return *candidate;
      outside = true;
    }
  }
  if (outside) {
    throw std::runtime_error(
        fmt::format("'{}' lies outside of the world's folder and the search paths; name its folder "
                    "in `search_paths`",
                    uri));
  }
  std::vector<std::string> folders;
  for (const fs::path& folder : folders_) folders.push_back(folder.string());
  throw ResourceMissing(uri, fmt::format("is not found in {}; name its folder in `search_paths`",
                                         fmt::join(folders, ", ")));
}

fs::path ResourceFinder::model_file(const fs::path& model) const {
  if (!fs::is_directory(model)) return model;
  fs::path file = model / "model.sdf";
  const fs::path config = model / "model.config";
  if (fs::is_regular_file(config)) {
    const auto document = parse_xml(config.string(), read_xml_text(config.string()));
    const TiXmlElement* entry = document->RootElement();
    entry = entry == nullptr ? nullptr : entry->FirstChildElement("sdf");
    for (; entry != nullptr; entry = entry->NextSiblingElement("sdf")) {
      if (entry->GetText() != nullptr) file = fs::weakly_canonical(model / entry->GetText());
    }
  }
  if (!fs::is_regular_file(file) || !may_read(fs::canonical(file))) {
    throw std::runtime_error(fmt::format("{}: the model's folder has no {} that may be read",
                                         model.string(), file.filename().string()));
  }
  return file;
}

}  // namespace castaway::sim
