/// Files that an SDF world names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace castaway::sim {

/// Resolves the URIs of one SDF world: `model://`, `package://`, `file://` and plain paths, from
/// the folder of the world, `models` in it and beside it, the search paths, and the folders of
/// GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH, GAZEBO_MODEL_PATH and SDF_PATH. What lies
/// outside of these folders is refused.
class ResourceFinder {
 public:
  ResourceFinder(const std::filesystem::path& world, const std::vector<std::string>& search_paths);

  /// The file or folder, absolute. `from`: the folder of the file that names it.
  /// @throws std::runtime_error naming what was looked for and where, or why it is refused.
  [[nodiscard]] std::filesystem::path find(const std::string& uri,
                                           const std::filesystem::path& from) const;
  /// The SDF file of a model: itself, or in its folder what its model.config names last, else
  /// model.sdf. @throws std::runtime_error if there is none.
  [[nodiscard]] std::filesystem::path model_file(const std::filesystem::path& model) const;

 private:
  [[nodiscard]] bool may_read(const std::filesystem::path& path) const;

  std::vector<std::filesystem::path> folders_;
};

}  // namespace castaway::sim
