#include "sim/world/mesh_cache.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "sim/world/mesh_file.hpp"
#include "xacro/files/lower_case.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEntryBytes = 200;  // Approximate size of an entry without its mesh.

/// 64-bit FNV-1a with two offsets, so that accidental collisions do not occur.
std::array<std::uint64_t, 2> hash_of(std::istream& stream) {
  constexpr std::uint64_t kPrime = 1099511628211U;
  std::array<std::uint64_t, 2> hash{14695981039346656037U, 1099511628227U};
  std::string block(1U << 16U, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount()) {
    for (const char c : std::string_view(block).substr(0, std::size_t(stream.gcount()))) {
      hash[0] = (hash[0] ^ static_cast<unsigned char>(c)) * kPrime;
      hash[1] = (hash[1] + static_cast<unsigned char>(c)) * (kPrime + 16U);
    }
  }
  return hash;
}

bool stands_alone(const std::string& extension) {
  return extension == ".stl" || extension == ".dae" || extension == ".ply";
}

/// Key of a file's content; nothing if the file cannot be read or is too large, which the reader
/// reports.
std::optional<std::string> key_of(const fs::path& path) {
  std::error_code none;
  if (!fs::is_regular_file(path, none) || fs::file_size(path, none) > kMaxMeshBytes) {
    return std::nullopt;
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  const auto hash = hash_of(stream);
  const std::string extension = to_lower(path.extension().string());
  const std::string folder = stands_alone(extension) ? "" : path.parent_path().string();
  return fmt::format("{:016x}{:016x} {} {} {}", hash[0], hash[1], fs::file_size(path, none),
                     extension, folder);
}

std::string without(const std::string& text, const std::string& path) {
  return text.starts_with(path) ? text.substr(path.size()) : ": " + text;
}

std::size_t size_of(const TriangleMesh& mesh) {
  return mesh.vertices.size() * 3 * sizeof(Eigen::Vector3f) + mesh.indices.size() * 4;
}

}  // namespace

TriangleMesh MeshCache::get(const std::string& path,
                            const std::function<TriangleMesh(const std::string&)>& read) {
  const auto key = key_of(path);
  if (!key) return read(path);
  const auto found = entries_.find(*key);
  if (found != entries_.end()) {
    if (const auto* mesh = std::get_if<TriangleMesh>(&found->second)) return *mesh;
    const auto& failure = std::get<Failure>(found->second);
    if (failure.too_large) throw std::length_error(path + failure.reason);
    throw std::runtime_error(path + failure.reason);
  }
  try {
    TriangleMesh mesh = read(path);
    keep(*key, mesh);
    return mesh;
  } catch (const std::length_error& error) {
    keep(*key, Failure{without(error.what(), path), true});
    throw;
  } catch (const std::runtime_error& error) {
    keep(*key, Failure{without(error.what(), path), false});
    throw;
  }
}

void MeshCache::keep(const std::string& key, Entry entry) {
  const auto* mesh = std::get_if<TriangleMesh>(&entry);
  const std::size_t bytes = kEntryBytes + key.size() + (mesh != nullptr ? size_of(*mesh) : 0);
  if (bytes_ + bytes > limit_) {
    entries_.clear();
    bytes_ = 0;
  }
  if (bytes > limit_) return;
  bytes_ += bytes;
  entries_.emplace(key, std::move(entry));
}

}  // namespace castaway::sim
