#include "sim/world/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>

namespace castaway::sim {
namespace {

constexpr std::uintmax_t kMaxBytes = 128U << 20U;
constexpr std::size_t kMaxTriangles = 1000000;

Eigen::Vector3f to_eigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }

Eigen::Vector3f diffuse(const aiScene& scene, const aiMesh& mesh) {
  aiColor3D color(0.7F, 0.7F, 0.7F);
  if (mesh.mMaterialIndex < scene.mNumMaterials) {
    scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, color);
  }
  return {color.r, color.g, color.b};
}

void append_faces(const aiMesh& mesh, std::uint32_t base, bool mirrored, TriangleMesh& out) {
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    out.indices.push_back(base + face.mIndices[0]);
    out.indices.push_back(base + face.mIndices[mirrored ? 2 : 1]);
    out.indices.push_back(base + face.mIndices[mirrored ? 1 : 2]);
  }
}

void append(const aiScene& scene, const aiMesh& mesh, const Eigen::Vector3f& scale,
            TriangleMesh& out) {
  const auto base = static_cast<std::uint32_t>(out.vertices.size());
  const Eigen::Vector3f color = diffuse(scene, mesh);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    out.vertices.push_back(to_eigen(mesh.mVertices[i]).cwiseProduct(scale));
    const Eigen::Vector3f normal =
        mesh.HasNormals() ? to_eigen(mesh.mNormals[i]) : Eigen::Vector3f::UnitZ();
    out.normals.push_back(normal.cwiseQuotient(scale).normalized());
    out.colors.push_back(color);
  }
  append_faces(mesh, base, scale.prod() < 0.0F, out);
}

/// Before anything of it is read.
void refuse_huge_file(const std::string& path) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  if (none || size <= kMaxBytes) return;
  throw std::length_error(fmt::format("{}: a mesh of {} MiB: at most {} are read; simplify it",
                                      path, size >> 20U, kMaxBytes >> 20U));
}

void refuse_huge_mesh(const std::string& path, const aiScene& scene) {
  std::size_t triangles = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) triangles += scene.mMeshes[i]->mNumFaces;
  if (triangles <= kMaxTriangles) return;
  throw std::length_error(
      fmt::format("{}: a mesh of {} triangles: at most {} are kept; simplify it", path, triangles,
                  kMaxTriangles));
}

}  // namespace

TriangleMesh load_mesh(const std::string& path, const Eigen::Vector3d& scale) {
  refuse_huge_file(path);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene =
      importer.ReadFile(path, aiProcess_Triangulate | aiProcess_GenNormals | aiProcess_SortByPType |
                                  aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    throw std::runtime_error(
        fmt::format("{}: cannot read this mesh ({})", path, importer.GetErrorString()));
  }
  refuse_huge_mesh(path, *scene);
  TriangleMesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    append(*scene, *scene->mMeshes[i], scale.cast<float>(), mesh);
  }
  if (mesh.indices.empty()) {
    throw std::runtime_error(fmt::format("{}: this mesh has no triangles", path));
  }
  return mesh;
}

}  // namespace castaway::sim
