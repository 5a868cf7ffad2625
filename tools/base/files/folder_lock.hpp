/// Ensures that only one castaway process works in a folder.
#pragma once

#include <filesystem>

namespace castaway::testbed {

/// A lock on the folder itself, so that no lock file remains if a process is killed.
class FolderLock {
 public:
  /// Waits at most `patience_s` [s] for another process. Throws std::runtime_error naming the
  /// folder if that process is still working in it, FileError if the folder cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder, double patience_s = 0.0);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace castaway::testbed
