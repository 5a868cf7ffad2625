#include "sim/world/mesh_file.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>

#include "xacro/files/git_lfs.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxTriangles = 1000000;

/// Opens regular files only: a pipe or device named by a material would never end.
class RegularFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* path) const override { return is_regular(path); }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    return is_regular(path) ? DefaultIOSystem::Open(path, mode) : nullptr;
  }

 private:
  static bool is_regular(const char* path) {
    std::error_code none;
    return fs::is_regular_file(path, none) && fs::file_size(path, none) <= kMaxMeshBytes;
  }
};

Eigen::Vector3f to_eigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }

Eigen::Vector3f diffuse(const aiScene& scene, const aiMesh& mesh) {
  aiColor3D color(0.7F, 0.7F, 0.7F);
  if (mesh.mMaterialIndex < scene.mNumMaterials) {
    scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, color);
  }
  return {color.r, color.g, color.b};
}

void append_faces(const aiMesh& mesh, std::uint32_t base, TriangleMesh& out) {
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    for (unsigned corner = 0; corner < 3; ++corner) {
      out.indices.push_back(base + face.mIndices[corner]);
    }
  }
}

void append(const aiScene& scene, const aiMesh& mesh, TriangleMesh& out) {
  const auto base = static_cast<std::uint32_t>(out.vertices.size());
  const Eigen::Vector3f color = diffuse(scene, mesh);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    out.vertices.push_back(to_eigen(mesh.mVertices[i]));
    out.normals.push_back(mesh.HasNormals() ? to_eigen(mesh.mNormals[i])
                                            : Eigen::Vector3f::UnitZ());
    out.colors.push_back(color);
  }
  append_faces(mesh, base, out);
}

/// Checks the file before anything of it is read.
void refuse_file(const std::string& path) {
  std::error_code none;
  if (fs::exists(path, none) && !fs::is_regular_file(path, none)) {
    throw std::runtime_error(path + ": cannot read this mesh (it is not a regular file)");
  }
  std::string head(64, '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), 64);
  if (is_git_lfs_pointer(head)) {
    throw std::runtime_error(fmt::format("{}: cannot read this mesh ({})", path, kGitLfsPointer));
  }
  const std::uintmax_t size = fs::file_size(path, none);
  if (none || size <= kMaxMeshBytes) return;
  throw std::length_error(fmt::format("{}: a mesh of {} MiB: at most {} are read; simplify it",
                                      path, size >> 20U, kMaxMeshBytes >> 20U));
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

TriangleMesh read_mesh_file(const std::string& path) {
  refuse_file(path);
  Assimp::Importer importer;
  importer.SetIOHandler(new RegularFiles);  // The importer owns it.
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
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene, *scene->mMeshes[i], mesh);
  return mesh;
}

}  // namespace castaway::sim
