/// A data set on disk, being made: nothing in it is ever half of something.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "tools/output/folder_lock.hpp"
#include "tools/output/interruption.hpp"

namespace castaway::testbed {

/// What a data set is made from. A folder keeps to one.
struct DatasetIdentity {
  std::string version;     ///< Of the program.
  std::uint64_t seed = 1;  ///< Root of all draws; stands in `spec`, too.
  int sequences = 0;
  std::string spec;  ///< `DatasetSpec::effective`
};

/// Throws std::runtime_error in one line that says what differs if `folder` holds a data set made
/// from something else, or other files. The same with fewer sequences is a beginning of this one.
void check_identity(const std::filesystem::path& folder, const DatasetIdentity& identity);

/// The folder:
///
///     dataset.json, dataset.yaml    the identity
///     sequences/000042/             a finished sequence
///     .work/                        whatever is being made; cleared at the start
///     manifest.json                 written last: the data set is finished
///
/// Files and sequences are made in .work, brought to the disk and renamed into place.
class DatasetFolder {
 public:
  /// Makes the folder or goes on with it. Only one process works in it at a time: the next one
  /// waits ten seconds for the end of the one before. Throws as `check_identity` does, and
  /// FileError where nothing can be written.
  DatasetFolder(std::filesystem::path folder, const DatasetIdentity& identity);
  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// True if all is done.
  [[nodiscard]] bool is_finished() const;
  [[nodiscard]] bool has_sequence(const std::string& name) const;
  [[nodiscard]] std::filesystem::path sequence(const std::string& name) const;
  /// Where a sequence is made.
  [[nodiscard]] std::filesystem::path draft(const std::string& name) const;
  /// A draft is complete: it takes its place.
  void commit_sequence(const std::string& name) const;
  /// Writes a file; `path` from the folder.
  void put(const std::string& path, std::string_view bytes) const;
  /// Removes .work; nothing more is written.
  void clear_work() const;

 private:
  Interruptible interruptible_;
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
};

}  // namespace castaway::testbed
