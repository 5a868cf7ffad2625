#include "tools/base/files/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {
namespace {

constexpr std::string_view kGitLfsPointer = "version https://git-lfs.github.com/spec/";

}  // namespace

void require_regular_file(const std::filesystem::path& path) {
  std::error_code none;
  const auto status = std::filesystem::status(path, none);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  const char* kind = std::filesystem::is_directory(status) ? "a folder"
                     : std::filesystem::is_fifo(status)    ? "a pipe"
                                                           : "a device";
  throw std::runtime_error(
      fmt::format("{}: cannot be read: it is {}; name a file", path.string(), kind));
}

std::string read_file(const std::filesystem::path& path, std::uintmax_t most) {
  require_regular_file(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(
        fmt::format("{}: cannot be read; check the path and its permissions", path.string()));
  }
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  if (!none && size > most) {
    throw std::runtime_error(fmt::format("{}: is longer than {} MiB, the most that is read of it",
                                         path.string(), most >> 20U));
  }
  std::string bytes(none ? 0 : static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream)
    bytes.append(std::istreambuf_iterator<char>(stream), {});  // The system states no size.
  if (bytes.starts_with(kGitLfsPointer)) {
    throw std::runtime_error(
        fmt::format("{}: only a Git LFS pointer: git lfs pull fetches the file", path.string()));
  }
  return bytes;
}

namespace {

/// Creates an empty file `<path>.part-<digits>` that was not there before, so that nothing is
/// written through a link; empty if that cannot be done.
std::filesystem::path create_beside(const std::filesystem::path& path) {
  constexpr int kMostTries = 100;
  for (int i = 0; i < kMostTries; ++i) {
    std::filesystem::path file = path;
    file += i == 0 ? fmt::format(".part-{}", ::getpid()) : fmt::format(".part-{}{}", ::getpid(), i);
    const int handle =
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (handle >= 0) {
      ::close(handle);
      return file;
    }
    if (errno != EEXIST) break;
  }
  return {};
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  temporary_ = create_beside(path_);
  if (!temporary_.empty()) stream_.open(temporary_, std::ios::binary);
  if (!stream_.is_open()) fail();
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view bytes) {
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) fail();
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) fail();
  committed_ = true;
}

void AtomicFile::fail() const {
  throw FileError(
      fmt::format("{}: cannot be written; check that its folder is writable and the disk not full",
                  path_.string()));
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace castaway::testbed
