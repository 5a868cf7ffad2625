// Tests where a bundled program takes its renderer from.
#include "tools/build/bundled_renderer.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "sim/render/renderer_variables.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

std::string drivers_folder() {
  const sim::RendererVariables variables;
  const char* folder = std::getenv("LIBGL_DRIVERS_PATH");
  return folder == nullptr ? "(the machine's)" : folder;
}

TEST(BundledRenderer, IsBesideTheProgramOrTheMachines) {
  const TemporaryFolder bundle;
  const std::filesystem::path program = bundle.put("bin/castaway", "");
  use_renderer_beside(program);
  EXPECT_EQ(drivers_folder(), "(the machine's)");
  const std::filesystem::path vendor = bundle.put("lib/renderer/vendor.json", "{}");
  use_renderer_beside(program);
  EXPECT_EQ(drivers_folder(), vendor.parent_path());
  sim::use_renderer_in("");
}

}  // namespace
}  // namespace castaway::testbed
