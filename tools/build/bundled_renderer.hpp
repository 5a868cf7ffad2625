/// The renderer of the portable bundle (docs/bundle.md).
#pragma once

#include <filesystem>

namespace castaway::testbed {

/// Takes the renderer in `../lib/renderer`, seen from the folder of a program, for all pictures.
/// Where there is none, it stays the machine's.
void use_renderer_beside(const std::filesystem::path& program);

}  // namespace castaway::testbed
