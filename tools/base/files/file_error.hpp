/// Error of the disk, as opposed to the data to be written.
#pragma once

#include <stdexcept>

namespace castaway::testbed {

/// A file or a folder cannot be written: the disk is full or read-only, or permission is missing.
/// Code that writes many files stops at the first such error.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace castaway::testbed
