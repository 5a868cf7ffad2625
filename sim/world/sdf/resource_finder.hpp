/// Files that an SDF world names.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace castaway::sim {

/// A file that a world names and that is nowhere.
class ResourceMissing : public std::runtime_error {
 public:
  ResourceMissing(std::string missing, const std::string& where)
      : std::runtime_error("'" + missing + "' " + where), uri(std::move(missing)), remedy(where) {}

  std::string uri;
  std::string remedy;  ///< "is not found in ...", and what to do.
};

/// Resolves the URIs of one SDF world: `model://`, `package://`, `file://` and plain paths, from
/// the folder of the world, `models` in it, beside it and above it, the search paths, and the
/// folders of GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, GAZEBO_MODEL_PATH and SDF_PATH. What
/// lies outside of these folders is refused. A name that is only there in other letter case is
/// taken.
class ResourceFinder {
 public:
  ResourceFinder(const std::filesystem::path& world, const std::vector<std::string>& search_paths);

  /// The file or folder, absolute. `from`: the folder of the file that names it.
  /// @throws ResourceMissing naming what was looked for and where; std::runtime_error saying why it
  /// is refused.
  [[nodiscard]] std::filesystem::path find(const std::string& uri,
                                           const std::filesystem::path& from) const;
  /// The SDF file of a model: itself, or in its folder what its model.config names last, else
  /// model.sdf. @throws std::runtime_error if there is none.
  [[nodiscard]] std::filesystem::path model_file(const std::filesystem::path& model) const;

 private:
  [[nodiscard]] bool may_read(const std::filesystem::path& path) const;

  std::vector<std::filesystem::path> folders_;  ///< What may be read...
  std::vector<std::filesystem::path> starts_;   ///< ...and where relative paths start.
};

}  // namespace castaway::sim
