/// Files behind mesh URIs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace castaway::sim {

/// Resolves `package://`, `model://`, `file://` and relative URIs of one URDF file. A package is an
/// ancestor folder of the file, or a folder beside one, that bears the package's name or whose
/// package.xml does; then the same below the search paths.
class MeshFinder {
 public:
  MeshFinder(const std::string& urdf_path, const std::vector<std::string>& search_paths);

  /// The file, absolute; nothing if it is nowhere.
  [[nodiscard]] std::optional<std::string> find(const std::string& uri) const;

 private:
  [[nodiscard]] std::optional<std::string> find_in_package(const std::string& package_path) const;

  std::vector<std::filesystem::path> ancestors_;  ///< The file's folder first, then search paths.
};

}  // namespace castaway::sim
