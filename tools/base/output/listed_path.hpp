/// Paths in lists of files that castaway reads back. Whoever gave the user the folder may have
/// written them, so they are checked as any input is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Why a text is no path of a list, as the end of a sentence ("leads out of its folder"). Empty if
/// it is one: relative, with slashes, without empty parts, "." and "..".
std::string listed_path_error(std::string_view path);

/// Throws std::runtime_error with one line if `listed_path_error` has one. `list`: the file with
/// the path.
void require_listed_path(const std::filesystem::path& list, std::string_view path);

/// The first link on the way from `folder` to `path` below it, `path` included; nothing if there is
/// none. `folder` itself may be one.
std::optional<std::filesystem::path> find_link(const std::filesystem::path& folder,
                                               const std::filesystem::path& path);

/// Throws std::runtime_error with one line if `find_link` finds one.
void require_no_link(const std::filesystem::path& folder, const std::filesystem::path& path);

/// True if `path` below `folder` is a folder, and no part of it is a link.
bool is_folder_below(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace castaway::testbed
