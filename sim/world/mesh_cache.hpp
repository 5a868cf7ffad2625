/// Caches meshes by the content of their files.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Caches meshes and the reasons why others could not be read. When its limit is exceeded, it drops
/// all entries.
class MeshCache {
 public:
  /// `limit`: of the cached data. [bytes]
  explicit MeshCache(std::size_t limit) : limit_(limit) {}

  /// Returns the mesh of a file: what `read(path)` returned, or threw, for the first file with the
  /// same content. For formats that refer to materials in other files, the folder must be the same,
  /// too.
  TriangleMesh get(const std::string& path,
                   const std::function<TriangleMesh(const std::string&)>& read);

 private:
  /// Reason why a file could not be read, without the file's name.
  struct Failure {
    std::string reason;
    bool too_large;  ///< The error was a std::length_error.
  };
  using Entry = std::variant<TriangleMesh, Failure>;

  void keep(const std::string& key, Entry entry);

  std::size_t limit_;
  std::size_t bytes_ = 0;
  std::map<std::string, Entry> entries_;
};

}  // namespace castaway::sim
