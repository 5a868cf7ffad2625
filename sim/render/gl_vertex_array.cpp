#include "sim/render/gl_vertex_array.hpp"

#include <cassert>

#include <epoxy/gl.h>

namespace castaway::sim {

GlVertexArray::GlVertexArray() {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
}

GlVertexArray::~GlVertexArray() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
}

void GlVertexArray::attribute(unsigned location, const std::vector<Eigen::Vector3f>& values) {
  upload(GL_ARRAY_BUFFER, values.data(), values.size() * sizeof(Eigen::Vector3f));
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), nullptr);
}

void GlVertexArray::indices(const std::vector<std::uint32_t>& values) {
  upload(GL_ELEMENT_ARRAY_BUFFER, values.data(), values.size() * sizeof(std::uint32_t));
}

void GlVertexArray::upload(unsigned kind, const void* data, std::size_t bytes) {
  unsigned buffer = 0;
  glGenBuffers(1, &buffer);
  buffers_.push_back(buffer);
  glBindBuffer(kind, buffer);
  glBufferData(kind, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

void draw_mesh(const TriangleMesh& mesh) {
  assert(mesh.normals.size() == mesh.vertices.size());
  if (mesh.indices.empty()) return;
  GlVertexArray array;
  array.attribute(0, mesh.vertices);
  array.attribute(1, mesh.normals);
  if (mesh.colors.empty()) {
    glVertexAttrib3f(2, 1.0F, 1.0F, 1.0F);
  } else {
    array.attribute(2, mesh.colors);
  }
  array.indices(mesh.indices);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace castaway::sim
