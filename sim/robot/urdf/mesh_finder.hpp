/// Finds the files of mesh URIs.
#pragma once

#include <optional>
#include <string>

#include "xacro/files/package_finder.hpp"

namespace castaway::sim {

/// Resolves `package://`, `model://`, `file://`, absolute and relative URIs of one robot. Relative
/// ones are searched in the file's folder, its package and the search paths.
class MeshFinder {
 public:
  explicit MeshFinder(const PackageFinder& packages) : packages_(&packages) {}

  /// Returns the absolute path of the file; nothing if it does not exist.
  /// @throws std::runtime_error if it lies where the robot must not read (see `PackageFinder`), and
  /// on an unknown scheme.
  [[nodiscard]] std::optional<std::string> find(const std::string& uri) const;

 private:
  [[nodiscard]] std::optional<std::string> if_file(const std::filesystem::path& path) const;
  [[nodiscard]] std::optional<std::string> in_package(const std::string& package_path) const;
  [[nodiscard]] std::optional<std::string> relative(const std::string& path) const;

  const PackageFinder* packages_;
};

}  // namespace castaway::sim
