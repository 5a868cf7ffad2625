/// Single files that a user names (`--junit`, `castaway map --out`): they replace nothing but what
/// castaway wrote there before.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace castaway::testbed {

/// Throws std::runtime_error in one line if something stands at `file` that castaway did not write
/// or that was changed since. For a check before long work.
void require_own_file(const std::filesystem::path& file);

/// Writes the whole file and notes it in its folder's list. Throws as `require_own_file` does, and
/// FileError.
void write_own_file(const std::filesystem::path& file, std::string_view bytes);

/// The same for a file that `put` brings to its place.
void put_own_file(const std::filesystem::path& file, const std::function<void()>& put);

}  // namespace castaway::testbed
