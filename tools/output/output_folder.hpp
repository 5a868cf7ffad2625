/// A folder that appears when it is complete, and takes the place of nothing but castaway's own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/output/file_record.hpp"
#include "tools/output/folder_lock.hpp"
#include "tools/output/interruption.hpp"

namespace castaway::testbed {

/// What goes where.
struct OutputRequest {
  std::filesystem::path target;
  std::string made_by;                          ///< Subcommand.
  std::string settings;                         ///< Hash of what it is made from.
  std::vector<std::filesystem::path> inputs{};  ///< Files that the command reads.
  bool force = false;                           ///< Other files may stand beside castaway's.
  bool keep_list = true;  ///< False for a folder that becomes part of another one.
};

/// Throws std::runtime_error in one line if the folder holds files that castaway did not write or
/// that were changed since (unless `force`), or an input of the command.
void check_output(const OutputRequest& request);

/// Removes what castaway wrote into the folder and nobody changed since; the folder, too, if it is
/// empty then.
void remove_output(const std::filesystem::path& folder);

/// A folder, being made. Everything is written into a hidden folder in the target, and moved into
/// the target by `commit`, which removes the files of an earlier run. Files that castaway did not
/// write stay, whatever is asked for. What a killed run left is cleared.
class OutputFolder {
 public:
  /// Throws as `check_output` does, as FolderLock does, and FileError if the folder cannot be made.
  explicit OutputFolder(OutputRequest request);
  /// Removes what was written unless `commit` was called.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& folder() const { return staging_; }
  /// Moves all of it into the target. Throws FileError, before anything is touched, if a file would
  /// take the place of one that castaway did not write.
  void commit();

 private:
  void require_replaceable(const FileHashes& files) const;
  void move(const FileHashes& files) const;

  Interruptible interruptible_;
  OutputRequest request_;
  std::filesystem::path made_;  ///< The topmost folder that had to be made; empty: none.
  std::filesystem::path staging_;
  std::optional<FolderLock> lock_;
  std::optional<FileRecord> record_;
};

}  // namespace castaway::testbed
