/// Compares a folder with its list of files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/base/output/file_record.hpp"

namespace castaway::testbed {

/// A file that differs from the list of its folder.
struct ForeignFile {
  std::string path;      ///< Relative to the folder.
  bool changed = false;  ///< True if castaway wrote the file but its content has changed since.
};

/// True for the name of a list, of the folder of drafts, and of what a killed process left of a
/// list.
bool is_bookkeeping(const std::string& name);

/// The first file, by name, that castaway did not write or that was changed since. Folders with
/// their own list and empty folders are ignored; links are not.
std::optional<ForeignFile> find_foreign(const std::filesystem::path& folder,
                                        const std::optional<FileRecord>& record);

/// Removes temporary files that a killed process left of the list itself.
void clear_leftovers(const std::filesystem::path& folder);

/// True if `path` may be replaced: nothing is there, or it is a file that `record` lists and is
/// unchanged. No folder on the path may be a link.
bool is_replaceable(const std::filesystem::path& folder, const std::string& path,
                    const std::optional<FileRecord>& record);

/// Ends what a killed process left: each of `coming` that arrived unchanged becomes one of `files`,
/// or, where the command of the folder had finished, of `single_files`.
FileRecord settle(const std::filesystem::path& folder, FileRecord record);

}  // namespace castaway::testbed
