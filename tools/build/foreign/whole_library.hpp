/// Finds shared libraries that were cut off: the system maps them, and the program is killed by
/// SIGBUS where it touches what is missing.
#pragma once

#include <filesystem>

namespace castaway::testbed {

/// Throws std::runtime_error if a file is a 64-bit ELF file (System V ABI, chapters 4 and 5) that
/// is shorter than its segments. Other files are left to the loader.
void require_whole_library(const std::filesystem::path& file);

}  // namespace castaway::testbed
