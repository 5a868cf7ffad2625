#include "tools/output/output_folder.hpp"

#include <fmt/format.h>

#include "tools/files/file_error.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// True if `file` is `folder` or lies in it.
bool lies_in(const fs::path& file, const fs::path& folder) {
  std::error_code none;
  const fs::path inner = fs::weakly_canonical(file, none);
  const fs::path outer = fs::weakly_canonical(folder, none);
  const fs::path relative = inner.lexically_relative(outer);
  return !relative.empty() && *relative.begin() != "..";
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why, const char* remedy) {
  throw std::runtime_error(fmt::format("{}: {}; {}", folder.string(), why, remedy));
}

constexpr const char* kElsewhere = "choose another folder with --out";
constexpr const char* kElsewhereOrForce =
    "choose another folder with --out, or --force to replace only what castaway wrote";

/// The topmost missing folder on the path to `target`; empty if `target` exists.
fs::path topmost_missing(const fs::path& target) {
  fs::path missing;
  std::error_code none;
  for (fs::path place = target; !place.empty() && !fs::exists(place, none);
       place = place.parent_path()) {
    missing = place;
  }
  return missing;
}

/// The record of an earlier run; nothing if that run was killed before it wrote anything.
std::optional<FileRecord> earlier_record(const fs::path& target) {
  std::optional<FileRecord> record = load_record(target);
  const bool empty = record && record->files.empty() && record->single_files.empty();
  return empty && !record->finished ? std::nullopt : record;
}

/// Merges two lists. A file whose hashes differ gets an empty hash, so that either content counts
/// as castaway's.
FileHashes unite(FileHashes one, const FileHashes& other) {
  for (const auto& [path, hash] : other) {
    const auto [place, is_new] = one.emplace(path, hash);
    if (!is_new && place->second != hash) place->second.clear();
  }
  return one;
}

void remove_empty_folders(fs::path from, const fs::path& to) {
  std::error_code none;
  while (from != to && fs::is_empty(from, none) && fs::remove(from, none)) {
    from = from.parent_path();
  }
}

/// Removes the files of a list and the folders that become empty.
void remove_listed(const fs::path& folder, const FileRecord& record) {
  for (const auto& [path, hash] : record.files) {
    if (!is_replaceable(folder, path, record)) continue;
    std::error_code none;
    fs::remove(folder / path, none);
    remove_empty_folders((folder / path).parent_path(), folder);
  }
}

}  // namespace

void check_output(const OutputRequest& request) {
  const fs::path& target = request.target;
  std::error_code none;
  if (!fs::exists(target, none)) return;
  if (!fs::is_directory(target, none)) refuse(target, "is not a folder", kElsewhere);
  for (const fs::path& input : request.inputs) {
    if (lies_in(input, target)) {
      refuse(target, fmt::format("holds the input {}", input.string()), kElsewhere);
    }
  }
  const std::optional<FileRecord> record = load_record(target);
  if (fs::exists(target / kStagingName, none) && !record) {
    refuse(target, fmt::format("holds '{}' without a list of files", kStagingName), kElsewhere);
  }
  if (request.force) return;
  if (const auto foreign = find_foreign(target, record)) {
    refuse(target,
           foreign->changed
               ? fmt::format("'{}' was changed since castaway wrote it", foreign->path)
               : fmt::format("holds '{}', which castaway did not write", foreign->path),
           kElsewhereOrForce);
  }
}

void remove_output(const fs::path& folder) {
  const std::optional<FileRecord> record = load_record(folder);
  if (!record) return;
  remove_listed(folder, *record);
  std::error_code none;
  fs::remove_all(folder / kStagingName, none);
  if (!record->single_files.empty()) return;
  fs::remove(folder / kRecordName, none);
  remove_empty_folders(folder, folder.parent_path());
}

OutputFolder::OutputFolder(OutputRequest request) : request_(std::move(request)) {
  fs::path& target = request_.target;
  target = fs::absolute(target).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();
  check_output(request_);
  made_ = topmost_missing(target);
  staging_ = target / kStagingName;
  std::error_code error;
  fs::create_directories(target, error);
  if (error) {
    throw FileError(
        fmt::format("{}: cannot be made ({}); {}", target.string(), error.message(), kElsewhere));
  }
  lock_.emplace(target);
  record_ = earlier_record(target);
  clear_leftovers(target, record_);
  if (!record_) save_record(target, {request_.made_by, request_.settings, false, {}, {}});
  fs::remove_all(staging_, error);
  fs::create_directories(staging_, error);
  if (error) {
    throw FileError(
        fmt::format("{}: cannot be made ({}); {}", staging_.string(), error.message(), kElsewhere));
  }
}

OutputFolder::~OutputFolder() {
  std::error_code none;
  const fs::path& target = request_.target;
  fs::remove_all(staging_, none);
  if (!record_) fs::remove(target / kRecordName, none);
  if (!made_.empty()) remove_empty_folders(target, made_.parent_path());
}

void OutputFolder::require_replaceable(const FileHashes& files) const {
  for (const auto& [path, hash] : files) {
    if (is_replaceable(request_.target, path, record_)) continue;
    throw FileError(fmt::format(
        "{}: castaway did not write what is there; move it away or choose another --out",
        (request_.target / path).string()));
  }
}

void OutputFolder::move(const FileHashes& files) const {
  for (const auto& [path, hash] : files) {
    const fs::path place = request_.target / path;
    fs::create_directories(place.parent_path());
    fs::rename(staging_ / path, place);
  }
}

void OutputFolder::commit() {
  const FileHashes files = hash_files(staging_);
  require_replaceable(files);
  FileRecord record{request_.made_by, request_.settings, false, {}, files};
  if (record_) record.single_files = record_->single_files;
  FileRecord both = record;
  if (record_) both.files = unite(files, record_->files);
  save_record(request_.target, both);
  if (record_) remove_listed(request_.target, *record_);
  move(files);
  record.finished = true;
  save_record(request_.target, record);
  record_ = record;
  if (!request_.keep_list) fs::remove(request_.target / kRecordName);
}

}  // namespace castaway::testbed
