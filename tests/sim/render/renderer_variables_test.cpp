// Tests the variables that lead EGL to the program's own renderer.
#include "sim/render/renderer_variables.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "(not set)" : value;
}

TEST(RendererVariables, AreThereWhileTheyLiveAndAsBeforeThen) {
  ::setenv("LIBGL_DRIVERS_PATH", "/of/the/user", 1);
  ::unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  {
    const RendererVariables none;
    EXPECT_EQ(variable("LIBGL_DRIVERS_PATH"), "/of/the/user");
  }
  use_renderer_in("/bundle/lib/renderer");
  {
    const RendererVariables variables;
    EXPECT_EQ(variable("LIBGL_DRIVERS_PATH"), "/bundle/lib/renderer");
    EXPECT_EQ(variable("__EGL_VENDOR_LIBRARY_FILENAMES"), "/bundle/lib/renderer/vendor.json");
    EXPECT_EQ(variable("MESA_SHADER_CACHE_DISABLE"), "true");
  }
  EXPECT_EQ(variable("LIBGL_DRIVERS_PATH"), "/of/the/user");
  EXPECT_EQ(variable("__EGL_VENDOR_LIBRARY_FILENAMES"), "(not set)");
  EXPECT_EQ(variable("MESA_SHADER_CACHE_DISABLE"), "(not set)");
  use_renderer_in("");
  ::unsetenv("LIBGL_DRIVERS_PATH");
}

}  // namespace
}  // namespace castaway::sim
