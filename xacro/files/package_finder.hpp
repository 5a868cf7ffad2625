/// Finds packages of a robot's description, and decides which files it may read.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace castaway {

/// Folders in CASTAWAY_PACKAGE_PATH and ROS_PACKAGE_PATH, and `share` below those in
/// AMENT_PREFIX_PATH, in this order; each variable is a list separated by colons.
std::vector<std::string> package_paths_of_environment();

/// Finds packages by name, for one robot.
///
/// The robot's own package is the nearest folder above its file that contains a package.xml or
/// model.config; without one it is the file's folder, or the parent of a folder called urdf, xacro,
/// robots or models. A file may be read if it lies in the own package, in a package that was found
/// by name, or in a search path. Links are followed: whoever can place a link can place the file.
class PackageFinder {
 public:
  PackageFinder(const std::string& robot_file, const std::vector<std::string>& search_paths);

  /// The folder of a package: an ancestor of the file with this folder name or whose package.xml
  /// has it; a folder beside an ancestor with a package.xml or model.config; or a folder below the
  /// search paths, up to four levels deep, with this name. Nothing if it is not found.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& package) const;
  /// False if the path, with its `..` resolved, lies outside of all allowed folders.
  [[nodiscard]] bool may_read(const std::filesystem::path& path) const;
  /// Where relative names start: the file's folder, its own package, then the search paths.
  [[nodiscard]] const std::vector<std::filesystem::path>& starts() const { return starts_; }
  /// "outside of the robot's package (FOLDER) ...": why `may_read` is false, and the remedy.
  [[nodiscard]] std::string refusal(const std::filesystem::path& path) const;

 private:
  [[nodiscard]] std::optional<std::filesystem::path> look_up(const std::string& package) const;
  [[nodiscard]] std::optional<std::filesystem::path> in_index(const std::string& package) const;

  std::filesystem::path own_;
  std::vector<std::filesystem::path> ancestors_;  ///< The file's folder first.
  std::vector<std::filesystem::path> search_paths_;
  std::vector<std::filesystem::path> starts_;
  /// Results of earlier calls of `find`.
  mutable std::map<std::string, std::optional<std::filesystem::path>> found_;
  /// Packages below the search paths; nothing before the first search.
  mutable std::optional<std::map<std::string, std::filesystem::path>> index_;
};

}  // namespace castaway
