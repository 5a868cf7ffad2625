#include "sim/world/mesh.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "sim/world/mesh_cache.hpp"
#include "sim/world/mesh_file.hpp"

namespace castaway::sim {
namespace {

constexpr std::size_t kKeptBytes = 256U << 20U;
constexpr float kFarthestVertex = 1e6F;  // [m]

/// The process-wide reader and cache.
struct Shared {
  std::mutex mutex;
  MeshReader reader = read_mesh_file;
  MeshCache cache{kKeptBytes};
};

Shared& shared() {
  static Shared instance;
  return instance;
}

/// Throws unless the mesh is valid: a reader may pass on the content of a broken file.
void require_sound(const std::string& path, const TriangleMesh& mesh) {
  if (mesh.indices.empty()) throw std::runtime_error(path + ": this mesh has no triangles");
  const auto count = mesh.vertices.size();
  const bool sound =
      mesh.normals.size() == count && mesh.colors.size() == count && mesh.indices.size() % 3 == 0 &&
      std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](auto i) { return i < count; });
  const bool near = std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const auto& v) {
    return (v.array().abs() <= kFarthestVertex).all();
  });
  if (sound && near) return;
  throw std::runtime_error(
      path + (sound ? ": cannot read this mesh (a vertex is not a number, or beyond 1000 km)"
                    : ": cannot read this mesh (its triangles refer to missing vertices)"));
}

TriangleMesh read_sound(const std::string& path) {
  TriangleMesh mesh = shared().reader(path);
  require_sound(path, mesh);
  return mesh;
}

void scale_by(const Eigen::Vector3f& scale, TriangleMesh& mesh) {
  for (Eigen::Vector3f& v : mesh.vertices) v = v.cwiseProduct(scale).eval();
  for (Eigen::Vector3f& n : mesh.normals) n = n.cwiseQuotient(scale).normalized();
  if (scale.prod() >= 0.0F) return;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
}

}  // namespace

void use_mesh_reader(MeshReader reader) {
  const std::lock_guard lock(shared().mutex);
  shared().reader = reader ? std::move(reader) : read_mesh_file;
}

TriangleMesh load_mesh(const std::string& path, const Eigen::Vector3d& scale) {
  const std::lock_guard lock(shared().mutex);
  TriangleMesh mesh = shared().cache.get(path, read_sound);
  scale_by(scale.cast<float>(), mesh);
  return mesh;
}

}  // namespace castaway::sim
