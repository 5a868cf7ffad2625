/// A folder that castaway writes into: its lock, its list of files and its drafts.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "tools/base/files/folder_lock.hpp"
#include "tools/base/output/file_record.hpp"

namespace castaway::testbed {

inline constexpr double kPatience = 10.0;  ///< [s] With a process that holds a folder only briefly.

/// Holds a folder. Files are made as drafts, listed as coming and renamed into place, so that a
/// process that ends at any moment leaves of each the old one or the new one, which the list knows
/// as castaway's.
class WorkFolder {
 public:
  /// Locks the folder, and ends what killed processes left of its list. Throws as FolderLock and
  /// `load_record` do, and std::runtime_error if drafts of others are there.
  explicit WorkFolder(std::filesystem::path folder, double patience_s = 0.0);
  /// Removes the drafts, and the list where it says nothing yet.
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  /// The list; an empty one where the folder has none.
  [[nodiscard]] FileRecord& record() { return record_; }
  /// Where files are made.
  [[nodiscard]] const std::filesystem::path& drafts() const { return drafts_; }

  /// Makes the folder of drafts. Where the folder has no list, `first` becomes it, and says whose
  /// the drafts are.
  void begin(const FileRecord& first);
  /// Saves the list.
  void save();
  /// Throws std::runtime_error if one of the files would replace one that castaway did not write.
  void require_replaceable(const FileHashes& files) const;
  /// Lists drafts as coming and renames them into place. Throws FileError.
  void move_in(const FileHashes& files);
  /// Makes a draft by `write` and moves it in. Returns its hash, for the list. Throws as
  /// `require_replaceable` and `move_in` do.
  std::string put(const std::string& name,
                  const std::function<void(const std::filesystem::path& draft)>& write);

 private:
  std::filesystem::path folder_;
  std::filesystem::path drafts_;
  FolderLock lock_;
  FileRecord record_;
  bool is_new_ = true;  ///< The list says nothing yet.
};

}  // namespace castaway::testbed
