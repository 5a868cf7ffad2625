/// One castaway at a time in a folder.
#pragma once

#include <filesystem>

namespace castaway::testbed {

/// A lock on the folder itself, so that nothing is left behind, whoever is killed.
class FolderLock {
 public:
  /// Waits at most `patience_s` for another process. Throws std::runtime_error naming the folder
  /// if that is still at work in it, FileError if the folder cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder, double patience_s = 0.0);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace castaway::testbed
