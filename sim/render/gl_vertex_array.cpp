#include "sim/render/gl_vertex_array.hpp"

#include <cassert>
#include <utility>

#include <epoxy/gl.h>

namespace castaway::sim {

GlVertexArray::GlVertexArray() {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
}

GlVertexArray::GlVertexArray(GlVertexArray&& other) noexcept
    : array_(std::exchange(other.array_, 0)), buffers_(std::move(other.buffers_)) {
  other.buffers_.clear();
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

void GlVertexArray::bind() const { glBindVertexArray(array_); }

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

GlMesh::GlMesh(const TriangleMesh& mesh) : corners_(static_cast<int>(mesh.indices.size())) {
  assert(mesh.normals.size() == mesh.vertices.size());
  if (corners_ == 0) return;
  array_.attribute(0, mesh.vertices);
  array_.attribute(1, mesh.normals);
  if (!mesh.colors.empty()) array_.attribute(2, mesh.colors);
  array_.indices(mesh.indices);
}

void GlMesh::draw() const {
  if (corners_ == 0) return;
  array_.bind();
  glVertexAttrib3f(2, 1.0F, 1.0F, 1.0F);  // White if the mesh has no colours.
  glDrawElements(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr);
}

std::vector<GlMesh> upload_meshes(const Scene& scene) {
  std::vector<GlMesh> meshes;
  meshes.reserve(scene.items.size());
  for (const SceneItem& item : scene.items) meshes.emplace_back(item.mesh);
  return meshes;
}

}  // namespace castaway::sim
