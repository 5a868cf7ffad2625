#include "tools/build/mesh_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <vector>

namespace castaway::testbed {
namespace {

constexpr char kMesh = 'm';
constexpr char kFailure = 'f';
constexpr char kTooLarge = 'l';

template <typename Value>
void append(const std::vector<Value>& values, std::string& out) {
  const std::uint64_t count = values.size();
  out.append(reinterpret_cast<const char*>(&count), sizeof count);
  out.append(reinterpret_cast<const char*>(values.data()), count * sizeof(Value));
}

/// Takes a list off the front; false if it is truncated.
template <typename Value>
bool take(std::string_view& bytes, std::vector<Value>& values) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count > bytes.size() / sizeof(Value)) return false;
  values.resize(count);
  if (count == 0) return true;  // memcpy requires non-null pointers.
  std::memcpy(static_cast<void*>(values.data()), bytes.data(), count * sizeof(Value));
  bytes.remove_prefix(count * sizeof(Value));
  return true;
}

}  // namespace

std::string to_bytes(const MeshAnswer& answer) {
  if (const auto* failure = std::get_if<MeshFailure>(&answer)) {
    return (failure->too_large ? kTooLarge : kFailure) + failure->text;
  }
  const auto& mesh = std::get<sim::TriangleMesh>(answer);
  std::string bytes(1, kMesh);
  append(mesh.vertices, bytes);
  append(mesh.normals, bytes);
  append(mesh.colors, bytes);
  append(mesh.indices, bytes);
  return bytes;
}

std::optional<MeshAnswer> mesh_answer(std::string_view bytes) {
  if (bytes.empty()) return std::nullopt;
  const char kind = bytes.front();
  bytes.remove_prefix(1);
  if (kind == kFailure || kind == kTooLarge) {
    return MeshFailure{std::string(bytes), kind == kTooLarge};
  }
  sim::TriangleMesh mesh;
  const bool whole = kind == kMesh && take(bytes, mesh.vertices) && take(bytes, mesh.normals) &&
                     take(bytes, mesh.colors) && take(bytes, mesh.indices) && bytes.empty();
  return whole ? std::optional<MeshAnswer>(std::move(mesh)) : std::nullopt;
}

}  // namespace castaway::testbed
