#include "tools/batch/jobs/rows_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/durable.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/batch/jobs/row_line.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_rows(const fs::path& file) {
  throw FileError(fmt::format("{}: cannot be written ({})", file.string(), std::strerror(errno)));
}

/// Length of the file up to the end of its last whole line.
off_t whole_lines(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(0, std::ios::end);
  off_t end = stream.tellg();
  char c = 0;
  while (end > 0) {
    stream.seekg(end - 1);
    stream.get(c);
    if (c == '\n') break;
    --end;
  }
  return end;
}

}  // namespace

RowsFile::RowsFile(fs::path file) : file_(std::move(file)) {
  require_no_link(folder_of(file_), file_.filename());
  require_regular_file(file_);
  handle_ = open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (handle_ < 0) fail_rows(file_);
  // Another error: the file system does not support locks.
  if (flock(handle_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(handle_);
    throw std::runtime_error(file_.string() + ": another castaway works on these; wait for it");
  }
  if (ftruncate(handle_, whole_lines(file_)) != 0) {
    close(handle_);
    fail_rows(file_);
  }
}

RowsFile::~RowsFile() { close(handle_); }

void RowsFile::add(const std::string& row) const {
  const std::string line = row + "\n";
  std::size_t written = 0;
  while (written < line.size()) {
    const ssize_t count = write(handle_, line.data() + written, line.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail_rows(file_);
    written += static_cast<std::size_t>(count);
  }
}

RowIndex::RowIndex(const fs::path& folder, int jobs) : places_(static_cast<std::size_t>(jobs)) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("rows") || !name.ends_with(".jsonl")) continue;
    require_no_link(folder, name);
    require_regular_file(entry.path());
    files_.push_back(entry.path());
  }
  std::sort(files_.begin(), files_.end());
  for (std::size_t i = 0; i < files_.size(); ++i) {
    streams_.emplace_back(files_[i], std::ios::binary);
    read(static_cast<std::int32_t>(i));
  }
}

void RowIndex::read(std::int32_t file) {
  const auto number = static_cast<std::size_t>(file);
  std::ifstream& stream = streams_[number];
  std::string line;
  std::int64_t offset = 0;
  for (int k = 1; std::getline(stream, line) && !stream.eof(); ++k) {  // The rest is half-written.
    const auto fail = [&](const std::string& what) {
      throw std::runtime_error(fmt::format("{}:{}: {}", files_[number].string(), k, what));
    };
    RowHead head;
    try {
      head = head_of(line);
    } catch (const std::runtime_error& error) {
      fail(error.what());
    }
    if (head.job < 0 || index(head.job) >= places_.size()) {
      fail(fmt::format("index {} is of no row here", head.job));
    }
    Place& place = places_[index(head.job)];
    if (place.file >= 0 && place.file != file) {
      fail(fmt::format("index {} is in {}, too", head.job,
                       files_[static_cast<std::size_t>(place.file)].string()));
    }
    place = {file, head.failed, offset};
    offset += static_cast<std::int64_t>(line.size()) + 1;
  }
  stream.clear();
}

std::vector<int> RowIndex::jobs() const {
  std::vector<int> jobs;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].file >= 0) jobs.push_back(static_cast<int>(i));
  }
  return jobs;
}

std::string RowIndex::line(int job) {
  const Place& place = places_[index(job)];
  std::ifstream& stream = streams_.at(static_cast<std::size_t>(place.file));
  stream.clear();
  stream.seekg(place.offset);
  std::string line;
  std::getline(stream, line);
  return line;
}

std::string rows_name(const Shard& shard) {
  return shard.is_all() ? "rows.jsonl"
                        : fmt::format("rows-{}-of-{}.jsonl", shard.index, shard.count);
}

}  // namespace castaway::testbed
