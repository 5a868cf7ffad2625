/// Writes files and folders that survive a crash of the machine.
#pragma once

#include <filesystem>
#include <string_view>

namespace castaway::testbed {

/// Folder of a file; "." if the path names none.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Flushes the data of a file or a folder to the disk. Throws FileError.
void sync_path(const std::filesystem::path& path);

/// Writes a whole file as `draft`, flushes it and renames it to `path` on the same file system,
/// replacing an older one. After a crash, `path` has either its old or its new content. Throws
/// FileError.
void write_durable(const std::filesystem::path& draft, const std::filesystem::path& path,
                   std::string_view bytes);

/// Flushes all files under the folder `draft`, then renames it to `path`, which must not exist.
/// Throws FileError.
void move_durable(const std::filesystem::path& draft, const std::filesystem::path& path);

}  // namespace castaway::testbed
