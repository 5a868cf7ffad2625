#include "tools/base/files/durable.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw FileError(fmt::format(
      "{}: cannot be written ({}); check that its folder is writable and the disk not full",
      path.string(), why));
}

void rename_durable(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) fail(to, error.message());
  sync_path(folder_of(to));
}

}  // namespace

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void sync_path(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool good = file >= 0 && ::fsync(file) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!good) fail(path, std::strerror(error));
}

void write_durable(const fs::path& draft, const fs::path& path, std::string_view bytes) {
  write_file(draft, bytes);
  sync_path(draft);
  std::error_code error;
  fs::create_directories(folder_of(path), error);
  if (error) fail(path, error.message());
  rename_durable(draft, path);
}

void move_durable(const fs::path& draft, const fs::path& path) {
  for (const auto& entry : fs::recursive_directory_iterator(draft)) sync_path(entry.path());
  sync_path(draft);
  rename_durable(draft, path);
}

}  // namespace castaway::testbed
