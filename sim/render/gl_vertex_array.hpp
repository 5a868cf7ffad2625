/// Vertices on their way to OpenGL.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/render/scene.hpp"

namespace castaway::sim {

/// Buffers of one draw call, gone with it. Needs a current context for all of its life.
class GlVertexArray {
 public:
  GlVertexArray();
  ~GlVertexArray();
  GlVertexArray(const GlVertexArray&) = delete;
  GlVertexArray& operator=(const GlVertexArray&) = delete;

  /// A vector for each vertex, at `location` of the program.
  void attribute(unsigned location, const std::vector<Eigen::Vector3f>& values);
  void indices(const std::vector<std::uint32_t>& values);

 private:
  void upload(unsigned kind, const void* data, std::size_t bytes);

  unsigned array_ = 0;
  std::vector<unsigned> buffers_;
};

/// Draws a mesh with positions at location 0, normals at 1 and colours at 2. The normals must be as
/// many as the vertices.
void draw_mesh(const TriangleMesh& mesh);

}  // namespace castaway::sim
