/// The folder of a data set that is being made. Its files and sequences are always complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "tools/base/output/interruption.hpp"
#include "tools/base/output/work_folder.hpp"
#include "tools/batch/jobs/shard.hpp"

namespace castaway::testbed {

/// What a data set is made from. It never changes within one folder.
struct DatasetIdentity {
  std::string version;     ///< Version of the program.
  std::uint64_t seed = 1;  ///< Root of all draws; also part of `spec`.
  int sequences = 0;
  std::string spec;  ///< `DatasetSpec::effective`
};

/// Throws std::runtime_error with one line that names the difference if `folder` holds other files
/// or a data set of another identity. A data set that differs only in having fewer sequences is
/// accepted, since it can be extended.
void check_identity(const std::filesystem::path& folder, const DatasetIdentity& identity);

/// The folder:
///
///     dataset.json, dataset.yaml    the identity
///     sequences/000042/             a finished sequence
///     .work/, .work-2-of-8/         drafts, of a shard; cleared at the start
///     manifest.json                 written last: the data set is finished
///
/// Files and sequences are made in .work, flushed to disk and renamed into place.
class DatasetFolder {
 public:
  /// Creates the folder or resumes in it. Only one process works in a folder, or for each shard of
  /// its sequences, at a time: a second one waits up to ten seconds for the first to end. Throws as
  /// `check_identity` does, and FileError where nothing can be written.
  DatasetFolder(std::filesystem::path folder, const DatasetIdentity& identity, Shard shard = {});
  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// True if the manifest is written and nothing is left to do.
  [[nodiscard]] bool is_finished() const;
  [[nodiscard]] bool has_sequence(const std::string& name) const;
  [[nodiscard]] std::filesystem::path sequence(const std::string& name) const;
  /// Where a sequence is made.
  [[nodiscard]] std::filesystem::path draft(const std::string& name) const;
  /// Renames a complete draft into place.
  void commit_sequence(const std::string& name) const;
  /// Writes a file; `path` is relative to the folder.
  void put(const std::string& path, std::string_view bytes) const;
  /// As `put`. Throws std::runtime_error if a file with other content is there.
  void put_new(const std::string& path, std::string_view bytes) const;
  /// Removes its drafts. Nothing may be written afterwards.
  void clear_work() const;

 private:
  [[nodiscard]] std::filesystem::path work() const;
  void clear_drafts();
  void begin(const DatasetIdentity& identity);

  Interruptible interruptible_;
  std::filesystem::path folder_;
  Shard shard_;
  std::optional<WorkFolder> whole_;  ///< Nothing in a shard.
  std::optional<FolderLock> share_;  ///< A shard's drafts.
};

}  // namespace castaway::testbed
