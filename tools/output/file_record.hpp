/// The list of files that castaway wrote into a folder. It is stored in the folder itself, so that
/// no command replaces or removes anything else.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

inline constexpr const char* kRecordName = ".castaway.json";         ///< File name of the list.
inline constexpr const char* kStagingName = ".castaway-unfinished";  ///< Folder of an unfinished
                                                                     ///< run.

/// SHA-256 by path, relative to the folder, with slashes. The hash is empty for files that hold
/// clock readings; their content is not compared, so that the list is the same in every repetition.
using FileHashes = std::map<std::string, std::string>;

/// The list of a folder. Equal settings give equal bytes.
struct FileRecord {
  std::string made_by;              ///< Subcommand that made the folder; empty if none did.
  std::string settings;             ///< Hash of the inputs of the folder.
  bool finished = true;             ///< False while a command writes and after it was killed.
  std::string program;              ///< Hash of the program; only while unfinished.
  FileHashes files;                 ///< Files that the next run replaces and removes together.
  FileHashes single_files{};        ///< Files written one at a time (`--junit`, `castaway map`).
  std::vector<std::string> runs{};  ///< Subfolders that were made together with it.
};

/// Loads the list of a folder; nothing if it has none. Throws std::runtime_error naming the file if
/// it is malformed.
std::optional<FileRecord> load_record(const std::filesystem::path& folder);

/// Writes the list atomically.
void save_record(const std::filesystem::path& folder, const FileRecord& record);

/// Hashes of all files under `folder` except for the list and staging. Files of clock readings have
/// no hash.
FileHashes hash_files(const std::filesystem::path& folder);

/// Hash of one file under `folder`, as stored in a list.
std::string hash_file(const std::filesystem::path& folder, const std::string& path);

/// A file that differs from the list of its folder.
struct ForeignFile {
  std::string path;      ///< Relative to the folder.
  bool changed = false;  ///< True if castaway wrote the file but its content has changed since.
};

/// The first file, by name, that castaway did not write or that was changed since. Folders with
/// their own list and empty folders are ignored; links are not.
std::optional<ForeignFile> find_foreign(const std::filesystem::path& folder,
                                        const std::optional<FileRecord>& record);

/// Removes temporary files that a killed process left for files of the list and for the list
/// itself.
void clear_leftovers(const std::filesystem::path& folder, const std::optional<FileRecord>& record);

/// True if `path` may be replaced: nothing is there, or it is a file that `record` lists and is
/// unchanged. No folder on the path may be a link.
bool is_replaceable(const std::filesystem::path& folder, const std::string& path,
                    const std::optional<FileRecord>& record);

}  // namespace castaway::testbed
