#include "tools/files/file.hpp"

#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "tools/files/file_error.hpp"

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

std::string read_file(const std::filesystem::path& path) {
  require_regular_file(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(
        fmt::format("{}: cannot be read; check the path and its permissions", path.string()));
  }
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.starts_with(kGitLfsPointer)) {
    throw std::runtime_error(
        fmt::format("{}: only a Git LFS pointer: git lfs pull fetches the file", path.string()));
  }
  return bytes;
}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  temporary_ = path_;
  temporary_ += fmt::format(".part-{}", ::getpid());
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail();
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
