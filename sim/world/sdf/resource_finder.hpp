/// Finds files that an SDF world refers to.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace castaway::sim {

/// A file that a world refers to does not exist.
class ResourceMissing : public std::runtime_error {
 public:
  ResourceMissing(std::string missing, const std::string& where)
      : std::runtime_error("'" + missing + "' " + where), uri(std::move(missing)), remedy(where) {}

  std::string uri;
  std::string remedy;  ///< "is not found in ...", and what to do.
};

/// Resolves the URIs of one SDF world: `model://`, `package://`, `file://` and plain paths. It
/// searches the world's folder, `models` in it, beside it and above it, the search paths, and the
/// folders of GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, GAZEBO_MODEL_PATH and SDF_PATH. Files
/// outside of these folders are refused. A name that exists only in different letter case is
/// accepted.
class ResourceFinder {
 public:
  ResourceFinder(const std::filesystem::path& world, const std::vector<std::string>& search_paths);

  /// Returns the absolute path of a file or folder. `from`: the folder of the file that names it.
  /// @throws ResourceMissing naming the file and the searched folders; std::runtime_error with the
  /// reason why it is refused.
  [[nodiscard]] std::filesystem::path find(const std::string& uri,
                                           const std::filesystem::path& from) const;
  /// Returns the SDF file of a model: the path itself or, in its folder, the last one that
  /// model.config names, or else model.sdf. @throws std::runtime_error if there is none.
  [[nodiscard]] std::filesystem::path model_file(const std::filesystem::path& model) const;

 private:
  [[nodiscard]] bool may_read(const std::filesystem::path& path) const;

  std::vector<std::filesystem::path> folders_;  ///< Folders that may be read.
  std::vector<std::filesystem::path> starts_;   ///< Folders where relative paths start.
};

}  // namespace castaway::sim
