#include "xacro/files/package_finder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "xacro/files/xml_text.hpp"

namespace castaway {
namespace {

namespace fs = std::filesystem;

constexpr int kIndexDepth = 4;
constexpr std::size_t kMaxFolders = 20000;   // Folders visited below the search paths.
constexpr std::size_t kAncestorsByName = 4;  // A folder's name farther up is a coincidence.

bool has_marker(const fs::path& folder) {
  std::error_code none;
  return fs::is_regular_file(folder / "package.xml", none) ||
         fs::is_regular_file(folder / "model.config", none);
}

/// The name in the folder's package.xml; empty if there is none.
std::string package_name(const fs::path& folder) {
  const fs::path file = folder / "package.xml";
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return "";
  try {
    const auto document = parse_xml(file.string(), read_xml_text(file.string()));
    const TiXmlElement* name = document->RootElement()->FirstChildElement("name");
    return name == nullptr || name->GetText() == nullptr ? "" : name->GetText();
  } catch (const std::runtime_error&) {
    return "";  // A broken package.xml names no package.
  }
}

void add_list(const char* variable, const std::string& below, std::vector<std::string>& paths) {
  const char* list = std::getenv(variable);
  std::istringstream stream(list == nullptr ? "" : list);
  for (std::string path; std::getline(stream, path, ':');) {
    if (!path.empty()) paths.push_back(path + below);
  }
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end();
}

/// Absolute path without `..` and without a trailing slash.
fs::path plain(const fs::path& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

fs::path own_package(const std::vector<fs::path>& ancestors) {
  const auto marked = std::find_if(ancestors.begin(), ancestors.end(), has_marker);
  if (marked != ancestors.end()) return *marked;
  constexpr std::array<const char*, 4> kFolders{"urdf", "xacro", "robots", "models"};
  const std::string name = ancestors.front().filename().string();
  const bool below = std::find(kFolders.begin(), kFolders.end(), name) != kFolders.end();
  return below && ancestors.size() > 1 ? ancestors[1] : ancestors.front();
}

}  // namespace

std::vector<std::string> package_paths_of_environment() {
  std::vector<std::string> paths;
  add_list("CASTAWAY_PACKAGE_PATH", "", paths);
  add_list("ROS_PACKAGE_PATH", "", paths);
  add_list("AMENT_PREFIX_PATH", "/share", paths);
  return paths;
}

PackageFinder::PackageFinder(const std::string& robot_file,
                             const std::vector<std::string>& search_paths) {
  for (fs::path folder = plain(robot_file).parent_path(); folder != folder.root_path();
       folder = folder.parent_path()) {
    ancestors_.push_back(folder);
  }
  if (ancestors_.empty()) ancestors_.push_back("/");
  own_ = own_package(ancestors_);
  for (const std::string& path : search_paths) search_paths_.push_back(plain(path));
  starts_ = {ancestors_.front(), own_};
  starts_.insert(starts_.end(), search_paths_.begin(), search_paths_.end());
}

std::optional<fs::path> PackageFinder::find(const std::string& package) const {
  const bool name = !package.empty() && package != "." && package != ".." &&
                    package.find('/') == std::string::npos;
  if (!name) return std::nullopt;
  const auto known = found_.find(package);
  if (known != found_.end()) return known->second;
  return found_[package] = look_up(package);
}

std::optional<fs::path> PackageFinder::look_up(const std::string& package) const {
  for (std::size_t i = 0; i < ancestors_.size(); ++i) {
    const fs::path& folder = ancestors_[i];
    if (package_name(folder) == package) return folder;
    if (folder.filename() == package && (has_marker(folder) || i < kAncestorsByName)) return folder;
    const fs::path beside = folder / package;
    if (has_marker(beside)) return beside;
  }
  for (const fs::path& path : search_paths_) {
    std::error_code none;
    if (path.filename() == package || package_name(path) == package) return path;
    if (fs::is_directory(path / package, none)) return path / package;
  }
  return in_index(package);
}

namespace {

/// Packages in folders of any name below the search paths.
std::map<std::string, fs::path> index_packages(const std::vector<fs::path>& search_paths) {
  std::map<std::string, fs::path> index;
  std::size_t looked_at = 0;
  for (const fs::path& path : search_paths) {
    std::error_code none;
    fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied,
                                           none);
    for (; entry != fs::recursive_directory_iterator() && looked_at < kMaxFolders;
         entry.increment(none)) {
      if (!entry->is_directory(none)) continue;
      ++looked_at;
      const bool hidden = entry->path().filename().string().starts_with(".");
      if (hidden || entry.depth() + 1 >= kIndexDepth) entry.disable_recursion_pending();
      if (!has_marker(entry->path())) continue;
      index.emplace(entry->path().filename().string(), entry->path());
      const std::string name = package_name(entry->path());
      if (!name.empty()) index.insert_or_assign(name, entry->path());
    }
  }
  return index;
}

}  // namespace

/// Also finds packages in folders with other names, below search paths and beside the own package.
std::optional<fs::path> PackageFinder::in_index(const std::string& package) const {
  if (!index_) index_ = index_packages(search_paths_);
  const auto found = index_->find(package);
  return found == index_->end() ? std::nullopt : std::optional<fs::path>(found->second);
}

bool PackageFinder::may_read(const fs::path& path) const {
  const fs::path file = plain(path);
  const auto holds = [&file](const fs::path& folder) { return lies_in(file, folder); };
  if (holds(own_) || std::any_of(search_paths_.begin(), search_paths_.end(), holds)) return true;
  return std::any_of(found_.begin(), found_.end(),
                     [&](const auto& entry) { return entry.second && holds(*entry.second); });
}

std::string PackageFinder::refusal(const fs::path& path) const {
  return fmt::format(
      "{} lies outside of the robot's package ({}) and of the search paths: move it there, or name "
      "its folder with --search-path",
      plain(path).string(), own_.string());
}

}  // namespace castaway
