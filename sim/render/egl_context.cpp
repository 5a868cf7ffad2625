#include "sim/render/egl_context.hpp"

#include <array>
#include <stdexcept>

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "sim/render/renderer_variables.hpp"

namespace castaway::sim {
namespace {

constexpr const char* kRemedy =
    "install Mesa's EGL (Debian: libegl1 libgl1-mesa-dri) or run without pictures";

[[noreturn]] void fail(const std::string& call) {
  throw std::runtime_error(fmt::format("no off-screen OpenGL: {} failed (EGL error 0x{:04x}); {}",
                                       call, eglGetError(), kRemedy));
}

EGLDisplay open_display() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    fail("finding EGL_MESA_platform_surfaceless");
  }
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplay(surfaceless)");
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) fail("eglInitialize");
  return display;
}

EGLContext create_context(EGLDisplay display) {
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("eglBindAPI(OpenGL)");
  constexpr std::array<EGLint, 7> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
  const EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
  if (context == EGL_NO_CONTEXT) fail("eglCreateContext(OpenGL 3.3 core)");
  return context;
}

}  // namespace

EglContext::EglContext() {
  const RendererVariables variables;
  display_ = open_display();
  context_ = create_context(display_);
  make_current();
}

EglContext::~EglContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  // No eglTerminate: the display belongs to the process, and other contexts may use it.
}

bool EglContext::try_make_current() const noexcept {
  return eglGetCurrentContext() == context_ ||
         eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

void EglContext::make_current() const {
  if (!try_make_current()) fail("eglMakeCurrent");
}

}  // namespace castaway::sim
