/// Vertex data in OpenGL buffers.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Owns the buffers of draw calls. Needs a current context during its whole life.
class GlVertexArray {
 public:
  GlVertexArray();
  ~GlVertexArray();
  GlVertexArray(const GlVertexArray&) = delete;
  GlVertexArray& operator=(const GlVertexArray&) = delete;
  GlVertexArray(GlVertexArray&& other) noexcept;
  GlVertexArray& operator=(GlVertexArray&&) = delete;

  /// Uploads one vector per vertex, for `location` of the program.
  void attribute(unsigned location, const std::vector<Eigen::Vector3f>& values);
  /// Makes these the buffers of draw calls.
  void bind() const;
  void indices(const std::vector<std::uint32_t>& values);

 private:
  void upload(unsigned kind, const void* data, std::size_t bytes);

  unsigned array_ = 0;
  std::vector<unsigned> buffers_;
};

/// A mesh uploaded for several draw calls: positions at location 0, normals at 1, colours at 2.
/// Needs a current context during its whole life.
class GlMesh {
 public:
  /// There must be as many normals as vertices.
  explicit GlMesh(const TriangleMesh& mesh);

  void draw() const;

 private:
  GlVertexArray array_;
  int corners_;
};

/// Uploads the meshes of a scene's items, in their order.
std::vector<GlMesh> upload_meshes(const Scene& scene);

}  // namespace castaway::sim
