/// Whole files: read at once, or written so that nobody ever sees half of one.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Throws std::runtime_error naming a path that is there and no regular file: a pipe or a device
/// may keep its reader waiting for ever.
void require_regular_file(const std::filesystem::path& path);

/// The bytes of a regular file. Throws std::runtime_error naming it if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// A file that appears under its name when it is complete, and never otherwise: written under a
/// temporary name in the same folder, then renamed.
class AtomicFile {
 public:
  /// Makes missing folders. Throws FileError, a std::runtime_error, if the folder is not writable.
  explicit AtomicFile(std::filesystem::path path);
  /// Removes what was written unless `commit` was called.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// Puts the file in its place, over an older one. Throws FileError if it could not be
  /// written whole, e.g. because the disk is full.
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a whole file, atomically.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace castaway::testbed
