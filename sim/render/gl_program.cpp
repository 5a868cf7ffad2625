#include "sim/render/gl_program.hpp"

#include <array>
#include <stdexcept>

#include <epoxy/gl.h>

namespace castaway::sim {
namespace {

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return shader;
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteShader(shader);
  throw std::runtime_error(std::string("OpenGL shader does not compile: ") + log.data());
}

}  // namespace

GlProgram::GlProgram(const char* vertex_source, const char* fragment_source)
    : id_(glCreateProgram()) {
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, vertex_source), compile(GL_FRAGMENT_SHADER, fragment_source)}) {
    glAttachShader(id_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(id_);
  GLint done = GL_FALSE;
  glGetProgramiv(id_, GL_LINK_STATUS, &done);
  if (done == GL_TRUE) return;
  std::array<char, 1024> log{};
  glGetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteProgram(id_);
  throw std::runtime_error(std::string("OpenGL program does not link: ") + log.data());
}

GlProgram::~GlProgram() { glDeleteProgram(id_); }

void GlProgram::use() const { glUseProgram(id_); }

void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(id_, uniform), value);
}

void GlProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(glGetUniformLocation(id_, uniform), 1, value.data());
}

void GlProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(glGetUniformLocation(id_, uniform), 1, value.data());
}

void GlProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
  glUniform4fv(glGetUniformLocation(id_, uniform), 1, value.data());
}

void GlProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(glGetUniformLocation(id_, uniform), 1, GL_FALSE, value.data());
}

void GlProgram::set_unit(const char* sampler, unsigned unit) const {
  glUniform1i(glGetUniformLocation(id_, sampler), static_cast<GLint>(unit));
}

}  // namespace castaway::sim
