/// Reads whole files, and writes files that are never visible half-written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Throws std::runtime_error naming the path if it exists and is not a regular file: reading a pipe
/// or a device could block for ever.
void require_regular_file(const std::filesystem::path& path);

/// Largest file that is read as a whole. [B]
inline constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30U;
/// Largest file of settings: its tree takes a hundred times as much memory. [B]
inline constexpr std::uintmax_t kLargestSettings = std::uintmax_t{8} << 20U;

/// Reads a regular file. Throws std::runtime_error naming it if it cannot be read, or before it is
/// read if it is longer than `most`.
std::string read_file(const std::filesystem::path& path, std::uintmax_t most = kLargestFile);

/// A file that appears only when it is complete: it is written under a temporary name in the same
/// folder, then renamed.
class AtomicFile {
 public:
  /// Creates missing folders. Throws FileError if the folder is not writable.
  explicit AtomicFile(std::filesystem::path path);
  /// Removes the temporary file unless `commit` was called.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// Renames the file into place, replacing an older one. Throws FileError if it could not be
  /// written completely, e.g. because the disk is full.
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a whole file atomically.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace castaway::testbed
