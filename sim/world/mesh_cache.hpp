/// Meshes that were read before, by the content of their files.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Keeps meshes, and the reasons why others could not be read. What it keeps is limited: over the
/// limit it forgets all.
class MeshCache {
 public:
  /// `limit` of what is kept. [bytes]
  explicit MeshCache(std::size_t limit) : limit_(limit) {}

  /// The mesh of a file: what `read(path)` gave, or threw, for the first file of that content. A
  /// format that takes materials from files beside it is told apart by its folder too.
  TriangleMesh get(const std::string& path,
                   const std::function<TriangleMesh(const std::string&)>& read);

 private:
  /// Why a file could not be read; texts without the file's name.
  struct Failure {
    std::string reason;
    bool too_large;  ///< std::length_error
  };
  using Entry = std::variant<TriangleMesh, Failure>;

  void keep(const std::string& key, Entry entry);

  std::size_t limit_;
  std::size_t bytes_ = 0;
  std::map<std::string, Entry> entries_;
};

}  // namespace castaway::sim
