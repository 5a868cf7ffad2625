/// A folder of runs and their summary, which a later call can resume.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/base/output/output_folder.hpp"

namespace castaway::testbed {

/// A run to make.
struct PlannedRun {
  std::string folder;    ///< Relative to the folder of all runs.
  std::string settings;  ///< Hash of the run's inputs.
};

/// How a process works in a folder of runs.
enum class RunsShare : std::uint8_t {
  kAll,      ///< It makes all runs.
  kSome,     ///< Others make runs of it at the same time. It has no common files.
  kCollect,  ///< It makes none: others have.
};

/// Holds a folder for each run, each with its own list of files, and common files.
class RunsFolder {
 public:
  /// Throws as `check_output` (also for the folders of the runs) and FolderLock do, and FileError.
  RunsFolder(OutputRequest request, std::vector<PlannedRun> runs,
             RunsShare share = RunsShare::kAll);
  [[nodiscard]] const std::filesystem::path& path() const { return request_.target; }
  /// The planned runs.
  [[nodiscard]] const std::vector<PlannedRun>& runs() const { return runs_; }
  /// True if an earlier, stopped call with the same settings and the same program finished this
  /// run; for a collector also if they have been collected before.
  [[nodiscard]] bool has_run(std::size_t index) const;
  /// Writes a common file.
  void put(const std::string& name, std::string_view bytes);
  /// As `put`; `write` is called with the path of a draft.
  void put_by(const std::string& name,
              const std::function<void(const std::filesystem::path& file)>& write);
  /// Call it when all is done. Removes the files and runs of an earlier call that this one did not
  /// make, and releases the folder.
  void finish();

 private:
  Interruptible interruptible_;
  OutputRequest request_;
  std::vector<PlannedRun> runs_;
  std::optional<WorkFolder> work_;
  FileRecord earlier_;
  bool goes_on_ = false;
  std::optional<KeptWork> kept_;
};

/// Hash of the running program, so that the work of two builds is never mixed.
std::string program_hash();

}  // namespace castaway::testbed
