/// A folder of runs and what they amount to, which a later call goes on with.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/output/folder_lock.hpp"
#include "tools/output/output_folder.hpp"

namespace castaway::testbed {

/// A run to be made.
struct PlannedRun {
  std::string folder;    ///< Relative to the folder of all.
  std::string settings;  ///< Hash of what it is made from.
};

/// Holds a folder for each run, each with a list of its files, and files of its own.
class RunsFolder {
 public:
  /// Throws as `check_output` does, also for the folders of the runs, as FolderLock does, and
  /// FileError.
  RunsFolder(OutputRequest request, std::vector<PlannedRun> runs);

  [[nodiscard]] const std::filesystem::path& path() const { return request_.target; }
  /// True if an earlier call with the same settings and the same program, which was stopped,
  /// finished this run.
  [[nodiscard]] bool has_run(std::size_t index) const;
  /// Writes a file of its own.
  void put(const std::string& name, std::string_view bytes);
  /// The same by `write`, which is given the file's place.
  void put_by(const std::string& name,
              const std::function<void(const std::filesystem::path& file)>& write);
  /// All is done: removes the files and runs of an earlier call that this one did not make, and
  /// lets go of the folder.
  void finish();

 private:
  Interruptible interruptible_;
  OutputRequest request_;
  std::vector<PlannedRun> runs_;
  std::optional<FolderLock> lock_;
  FileRecord earlier_;
  FileRecord record_;
  bool goes_on_ = false;
};

/// Hash of the program that runs, so that what another build began is not mixed with its own.
std::string program_hash();

}  // namespace castaway::testbed
