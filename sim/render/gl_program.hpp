/// A linked OpenGL program and its uniforms.
#pragma once

#include <string>

#include <Eigen/Core>

namespace castaway::sim {

/// Owns a program; needs a current context during its whole life.
class GlProgram {
 public:
  /// @throws std::runtime_error with the driver's log if a shader does not compile or link.
  GlProgram(const char* vertex_source, const char* fragment_source);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  /// Sets the texture unit that a sampler reads.
  void set_unit(const char* sampler, unsigned unit) const;

 private:
  unsigned id_;
};

}  // namespace castaway::sim
