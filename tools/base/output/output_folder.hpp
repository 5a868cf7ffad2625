/// An output folder that appears only when it is complete and replaces only castaway's own files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/base/output/interruption.hpp"
#include "tools/base/output/work_folder.hpp"

namespace castaway::testbed {

/// Parameters of an output folder.
struct OutputRequest {
  std::filesystem::path target;
  std::string made_by;                          ///< Subcommand.
  std::string settings;                         ///< Hash of the inputs.
  std::vector<std::filesystem::path> inputs{};  ///< Files that the command reads.
  bool force = false;                           ///< Other files may exist beside castaway's.
  bool keep_list = true;  ///< False for a folder that becomes part of another one.
  std::string label{};  ///< What tells these settings from the usual ones, as part of a file name.
};

/// Throws std::runtime_error with one line if the folder holds an input of the command or (unless
/// `force`) files that castaway did not write or that were changed since.
void check_output(const OutputRequest& request);

/// Removes the files of the folder that castaway wrote and that are unchanged, and the folder if it
/// becomes empty.
void remove_output(const std::filesystem::path& folder);

/// Moves the finished output folder `draft` to `target` on the same file system, where it replaces
/// only what castaway wrote before. Throws as OutputFolder does, and std::runtime_error if `target`
/// is a link.
void replace_output(const std::filesystem::path& draft, const std::filesystem::path& target);

/// A folder that is being made. Everything is written into a hidden folder inside the target and
/// moved by `commit`, which removes the files of an earlier run. Files that castaway did not write
/// are always kept. The remains of a killed run are removed.
class OutputFolder {
 public:
  /// Throws as `check_output`, `make_folder` and FolderLock do.
  explicit OutputFolder(OutputRequest request);
  /// Removes everything that was written unless `commit` was called.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The folder to write into.
  [[nodiscard]] const std::filesystem::path& folder() const { return work_->drafts(); }
  /// Moves all files into the target. Throws std::runtime_error, before any change, if a file would
  /// replace one that castaway did not write. `complete`: false if some files could not be made.
  void commit(bool complete = true);
  [[nodiscard]] bool is_committed() const { return committed_; }

 private:
  Interruptible interruptible_;
  OutputRequest request_;
  std::filesystem::path made_;  ///< The topmost folder that had to be created; empty if none.
  std::optional<WorkFolder> work_;
  bool committed_ = false;
};

}  // namespace castaway::testbed
