/// Leads EGL to a renderer that comes with the program, in place of the machine's.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace castaway::sim {

/// All contexts to come are of Mesa's software renderer in `folder`: `swrast_dri.so`, and
/// `vendor.json`, which names the library of Mesa's EGL to libglvnd. Call it before all others.
void use_renderer_in(const std::filesystem::path& folder);

/// Sets Mesa's variables for the renderer of `use_renderer_in`, and restores them in the
/// destructor: programs that this process starts get its own environment. Mesa keeps no shaders in
/// the user's home then. Without such a renderer it does nothing. Mesa reads them until a context
/// is made.
class RendererVariables {
 public:
  RendererVariables();
  ~RendererVariables();
  RendererVariables(const RendererVariables&) = delete;
  RendererVariables& operator=(const RendererVariables&) = delete;

 private:
  std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

}  // namespace castaway::sim
