/// An OpenGL context without a window.
#pragma once

#include <string>

namespace castaway::sim {

/// Owns an EGL display and a current OpenGL 3.3 core context on Mesa's surfaceless platform. GL
/// objects must be destroyed before the context.
class EglContext {
 public:
  /// @throws std::runtime_error naming the call that failed and the remedy.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// Makes the context current on this thread.
  void make_current() const;
  /// Does the same for destructors; false if it fails.
  [[nodiscard]] bool try_make_current() const noexcept;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace castaway::sim
