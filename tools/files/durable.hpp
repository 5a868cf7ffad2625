/// Files and folders that a crash of the machine does not take back.
#pragma once

#include <filesystem>
#include <string_view>

namespace castaway::testbed {

/// Brings a file's or a folder's own data to the disk. Throws FileError.
void sync_path(const std::filesystem::path& path);

/// Writes a whole file under `draft`, brings it to the disk, then gives it its place `path` on the
/// same file system, over an older one. Whatever happens, `path` has its old content or the new
/// one. Throws FileError.
void write_durable(const std::filesystem::path& draft, const std::filesystem::path& path,
                   std::string_view bytes);

/// Brings all files under the folder `draft` to the disk, then gives it its place `path`, where
/// there must be nothing. Throws FileError.
void move_durable(const std::filesystem::path& draft, const std::filesystem::path& path);

}  // namespace castaway::testbed
