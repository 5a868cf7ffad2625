/// Trouble with the disk, not with what was to be written.
#pragma once

#include <stdexcept>

namespace castaway::testbed {

/// A file or a folder cannot be written: the disk is full or read-only, the folder is not ours.
/// Whoever makes many files stops at the first.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace castaway::testbed
