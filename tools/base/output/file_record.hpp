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
/// clock readings, so that the list is the same in every repetition; `is_clock_file` stands in.
using FileHashes = std::map<std::string, std::string>;

/// The list of a folder. Equal settings give equal bytes.
struct FileRecord {
  std::string made_by;              ///< Subcommand that made the folder; empty if none did.
  std::string settings;             ///< Hash of the inputs of the folder.
  bool finished = true;             ///< False while a command writes and after it was killed.
  std::string program;              ///< Hash of the program; only while unfinished.
  FileHashes files;                 ///< Files that the next run replaces and removes together.
  FileHashes single_files{};        ///< Files written one at a time (`--junit`, `castaway map`).
  FileHashes coming{};              ///< Files on their way into the folder.
  std::vector<std::string> runs{};  ///< Subfolders that were made together with it.
};

/// Loads the list of a folder; nothing if it has none. Throws std::runtime_error naming the file if
/// it is malformed or a link, or if a path leads out of the folder: whoever gave the user the
/// folder may have written the list.
std::optional<FileRecord> load_record(const std::filesystem::path& folder);

/// Writes the list atomically.
void save_record(const std::filesystem::path& folder, const FileRecord& record);

/// Hashes of all files under `folder` except for the list and staging. Files of clock readings have
/// no hash.
FileHashes hash_files(const std::filesystem::path& folder);

/// Hash of one file under `folder`, as stored in a list.
std::string hash_file(const std::filesystem::path& folder, const std::string& path);

}  // namespace castaway::testbed
