/// Checks the files of an SDF world before libsdformat reads them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <tinyxml.h>

#include "sim/world/sdf/resource_finder.hpp"

namespace castaway::sim {

/// Reads everything that a world includes, at all depths. Refuses files that are not harmless XML
/// (see `parse_xml`), models that include themselves, more than 20 levels and more than 5000
/// inclusions.
class IncludeCheck {
 public:
  /// `world`: the file. `finder` must outlive this.
  IncludeCheck(const std::filesystem::path& world, const ResourceFinder& finder)
      : finder_(finder), open_{std::filesystem::weakly_canonical(world)} {}

  /// Follows the includes below an element of the world.
  /// @throws std::runtime_error naming file and reason if one cannot be read; std::length_error if
  /// they are too many, too deep or circular.
  void follow(const TiXmlNode& element);

 private:
  void visit(const std::string& uri);
  [[nodiscard]] const std::vector<std::string>& includes_of(const std::filesystem::path& file);

  const ResourceFinder& finder_;
  std::vector<std::filesystem::path> open_;
  std::map<std::filesystem::path, std::vector<std::string>> includes_;
  int inclusions_ = 0;
};

}  // namespace castaway::sim
