/// Packages of a robot's description, and which files it may name.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace castaway::sim {

/// Folders in CASTAWAY_PACKAGE_PATH and ROS_PACKAGE_PATH, and `share` below those in
/// AMENT_PREFIX_PATH, in this order; each a list with colons.
std::vector<std::string> package_paths_of_environment();

/// Finds packages by name, for one robot.
///
/// The robot's own package is the nearest folder above its file that holds a package.xml or
/// model.config; without one the file's folder, or the one above if that is called urdf, xacro,
/// robots or models. A file may be read if it lies in the own package, in a package that was found
/// by name, or in a search path. Links are followed: who may put one there may put the file there.
class PackageFinder {
 public:
  PackageFinder(const std::string& robot_file, const std::vector<std::string>& search_paths);

  /// The folder of a package: an ancestor of the file that bears its name or whose package.xml
  /// does; a folder with a package.xml or model.config beside one; below the search paths, up to
  /// four levels deep, whatever bears the name. Nothing if it is nowhere.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& package) const;
  /// False if the path, after its `..` have been followed, lies outside of all that is allowed.
  [[nodiscard]] bool may_read(const std::filesystem::path& path) const;
  /// The file's folder, its own package, then the search paths: where relative names start.
  [[nodiscard]] const std::vector<std::filesystem::path>& starts() const { return starts_; }
  /// "outside of the robot's package (FOLDER) ...": why `may_read` says no, and what to do.
  [[nodiscard]] std::string refusal(const std::filesystem::path& path) const;

 private:
  [[nodiscard]] std::optional<std::filesystem::path> look_up(const std::string& package) const;
  [[nodiscard]] std::optional<std::filesystem::path> in_index(const std::string& package) const;

  std::filesystem::path own_;
  std::vector<std::filesystem::path> ancestors_;  ///< The file's folder first.
  std::vector<std::filesystem::path> search_paths_;
  std::vector<std::filesystem::path> starts_;
  /// What has been asked for; nothing: not there.
  mutable std::map<std::string, std::optional<std::filesystem::path>> found_;
  /// Packages below the search paths; nothing: not yet looked.
  mutable std::optional<std::map<std::string, std::filesystem::path>> index_;
};

}  // namespace castaway::sim
