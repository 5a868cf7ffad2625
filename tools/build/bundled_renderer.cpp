#include "tools/build/bundled_renderer.hpp"

#include "sim/render/renderer_variables.hpp"

namespace castaway::testbed {

void use_renderer_beside(const std::filesystem::path& program) {
  std::error_code none;
  const auto prefix = std::filesystem::canonical(program, none).parent_path().parent_path();
  const auto folder = prefix / "lib/renderer";
  if (std::filesystem::is_regular_file(folder / "vendor.json", none)) sim::use_renderer_in(folder);
}

}  // namespace castaway::testbed
