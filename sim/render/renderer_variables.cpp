#include "sim/render/renderer_variables.hpp"

#include <cstdlib>

namespace castaway::sim {
namespace {

std::filesystem::path& renderer_folder() {
  static std::filesystem::path folder;
  return folder;
}

std::vector<std::pair<std::string, std::string>> variables_of(const std::filesystem::path& folder) {
  return {{"__EGL_VENDOR_LIBRARY_FILENAMES", folder / "vendor.json"},
          {"LIBGL_DRIVERS_PATH", folder},
          {"LIBGL_ALWAYS_SOFTWARE", "true"},
          {"MESA_SHADER_CACHE_DISABLE", "true"}};
}

}  // namespace

void use_renderer_in(const std::filesystem::path& folder) { renderer_folder() = folder; }

RendererVariables::RendererVariables() {
  if (renderer_folder().empty()) return;
  for (const auto& [name, value] : variables_of(renderer_folder())) {
    const char* before = std::getenv(name.c_str());
    before_.emplace_back(name,
                         before == nullptr ? std::nullopt : std::optional<std::string>(before));
    ::setenv(name.c_str(), value.c_str(), 1);
  }
}

RendererVariables::~RendererVariables() {
  for (const auto& [name, value] : before_) {
    if (value) {
      ::setenv(name.c_str(), value->c_str(), 1);
    } else {
      ::unsetenv(name.c_str());
    }
  }
}

}  // namespace castaway::sim
