/// What castaway wrote into a folder: a list that stands in the folder itself, so that no command
/// replaces or removes anything else.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

inline constexpr const char* kRecordName = ".castaway.json";         ///< The list.
inline constexpr const char* kStagingName = ".castaway-unfinished";  ///< Of a run under way.

/// SHA-256 by path, relative to the folder, with slashes. Empty: a file that holds clock readings,
/// whose content is not compared, so that the list is the same in every repetition.
using FileHashes = std::map<std::string, std::string>;

/// The list. The same settings give the same bytes.
struct FileRecord {
  std::string made_by;              ///< Subcommand that made the folder; empty: none did.
  std::string settings;             ///< Hash of what the folder was made from.
  bool finished = true;             ///< False while a command writes, and after it was killed.
  std::string program;              ///< Hash of the program, while unfinished.
  FileHashes files;                 ///< Replaced and removed together, by the next run.
  FileHashes single_files{};        ///< Written one at a time (`--junit`, `castaway map`).
  std::vector<std::string> runs{};  ///< Folders in it that were made together with it.
};

/// The list of a folder; nothing if it has none. Throws std::runtime_error naming the file if it
/// is not a list.
std::optional<FileRecord> load_record(const std::filesystem::path& folder);

/// Writes the list, at once.
void save_record(const std::filesystem::path& folder, const FileRecord& record);

/// Hashes of all files under `folder`, the list and staging aside. Clock readings have no hash.
FileHashes hash_files(const std::filesystem::path& folder);

/// Hash of one file under `folder`, as a list holds it.
std::string hash_file(const std::filesystem::path& folder, const std::string& path);

/// How a folder's content differs from its list.
struct ForeignFile {
  std::string path;      ///< Relative to the folder.
  bool changed = false;  ///< castaway wrote it, somebody else has changed it since.
};

/// The first file, by name, that castaway did not write or that was changed since. Folders with a
/// list of their own and empty folders do not count; links do.
std::optional<ForeignFile> find_foreign(const std::filesystem::path& folder,
                                        const std::optional<FileRecord>& record);

/// Removes what a killed process left half-written beside the files of the list, and of the list
/// itself.
void clear_leftovers(const std::filesystem::path& folder, const std::optional<FileRecord>& record);

/// True if `path` may be replaced: nothing is there, or the file that `record` lists, unchanged.
/// No folder on the way may be a link.
bool is_replaceable(const std::filesystem::path& folder, const std::string& path,
                    const std::optional<FileRecord>& record);

}  // namespace castaway::testbed
