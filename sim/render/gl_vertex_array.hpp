/// Vertices on their way to OpenGL.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Buffers of draw calls, gone with it. Needs a current context for all of its life.
class GlVertexArray {
 public:
  GlVertexArray();
  ~GlVertexArray();
  GlVertexArray(const GlVertexArray&) = delete;
  GlVertexArray& operator=(const GlVertexArray&) = delete;
  GlVertexArray(GlVertexArray&& other) noexcept;
  GlVertexArray& operator=(GlVertexArray&&) = delete;

  /// A vector for each vertex, at `location` of the program.
  void attribute(unsigned location, const std::vector<Eigen::Vector3f>& values);
  /// Makes the buffers what is drawn.
  void bind() const;
  void indices(const std::vector<std::uint32_t>& values);

 private:
  void upload(unsigned kind, const void* data, std::size_t bytes);

  unsigned array_ = 0;
  std::vector<unsigned> buffers_;
};

/// A mesh on its way to several draw calls: positions at location 0, normals at 1, colours at 2.
/// Needs a current context for all of its life.
class GlMesh {
 public:
  /// The normals must be as many as the vertices.
  explicit GlMesh(const TriangleMesh& mesh);

  void draw() const;

 private:
  GlVertexArray array_;
  int corners_;
};

/// The meshes of a scene's items, in their order.
std::vector<GlMesh> upload_meshes(const Scene& scene);

}  // namespace castaway::sim
