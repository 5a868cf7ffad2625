/// Single files named by the user (`--junit`, `castaway map --out`). They replace only what
/// castaway wrote there before.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace castaway::testbed {

/// Throws std::runtime_error with one line if `file` exists and castaway did not write it, or it
/// was changed since. Use it as a check before long work.
void require_own_file(const std::filesystem::path& file);

/// Writes the whole file and adds it to its folder's list. Throws as `require_own_file` does, and
/// FileError.
void write_own_file(const std::filesystem::path& file, std::string_view bytes);

/// As `write_own_file`; `write` is called with the path of a draft. A process that ends at any
/// moment leaves the old file or the new one, and the list knows it as castaway's.
void put_own_file(const std::filesystem::path& file,
                  const std::function<void(const std::filesystem::path& draft)>& write);

}  // namespace castaway::testbed
