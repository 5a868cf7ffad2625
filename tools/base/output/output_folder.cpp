#include "tools/base/output/output_folder.hpp"

#include <utility>

#include <fmt/format.h>

#include "tools/base/files/durable.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"

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

void remove_empty_folders(fs::path from, const fs::path& to) {
  std::error_code none;
  while (from != to && fs::is_empty(from, none) && fs::remove(from, none)) {
    from = from.parent_path();
  }
}

/// Removes the files of a list and the folders that become empty. Throws FileError where a file
/// stays: its list must stay, too.
void remove_listed(const fs::path& folder, const FileRecord& record) {
  for (const auto& [path, hash] : record.files) {
    if (!is_replaceable(folder, path, record)) continue;
    std::error_code error;
    fs::remove(folder / path, error);
    if (error) {
      throw FileError(fmt::format("{}: cannot be removed ({}); repeat the command when it can",
                                  (folder / path).string(), error.message()));
    }
    remove_empty_folders((folder / path).parent_path(), folder);
  }
}

}  // namespace

void check_output(const OutputRequest& request) {
  const fs::path& target = request.target;
  std::error_code none;
  if (!fs::exists(target, none)) return;
  if (!fs::is_directory(target, none)) refuse_folder(target, "is not a folder");
  for (const fs::path& input : request.inputs) {
    if (lies_in(input, target)) {
      refuse_folder(target, fmt::format("holds the input {}", input.string()));
    }
  }
  const std::optional<FileRecord> record = load_record(target);
  if (fs::exists(target / kStagingName, none) && !record) {
    refuse_folder(target, fmt::format("holds '{}' without a list of files", kStagingName));
  }
  if (request.force) return;
  if (const auto foreign = find_foreign(target, record)) {
    throw std::runtime_error(fmt::format(
        "{}: {}; choose another folder with --out, or --force to replace only what castaway wrote",
        target.string(),
        foreign->changed ? fmt::format("'{}' was changed since castaway wrote it", foreign->path)
                         : fmt::format("holds '{}', which castaway did not write", foreign->path)));
  }
}

void remove_output(const fs::path& folder) {
  std::optional<FileRecord> record = load_record(folder);
  if (!record) return;
  record = settle(folder, std::move(*record));
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
  make_folder(target);
  work_.emplace(target);
  work_->begin({request_.made_by, request_.settings, false, {}, {}});
}

OutputFolder::~OutputFolder() {
  work_.reset();
  if (!made_.empty()) remove_empty_folders(request_.target, made_.parent_path());
}

void OutputFolder::commit(bool complete) {
  const FileHashes files = hash_files(folder());
  work_->require_replaceable(files);
  FileRecord& record = work_->record();
  const FileRecord earlier = record;
  record = {request_.made_by, request_.settings, false, {}, earlier.files, earlier.single_files};
  work_->save();
  remove_listed(request_.target, earlier);
  work_->move_in(files);
  record.files = files;
  record.finished = complete;
  work_->save();
  committed_ = true;
  if (!request_.keep_list) fs::remove(request_.target / kRecordName);
}

void replace_output(const fs::path& draft, const fs::path& target) {
  require_no_link(folder_of(target), target.filename());
  if (!fs::exists(target)) {
    fs::create_directories(folder_of(target));
    return fs::rename(draft, target);
  }
  const FileRecord record = load_record(draft).value_or(FileRecord{});
  OutputFolder output({target, record.made_by, record.settings, {}, true});
  for (const auto& entry : fs::directory_iterator(draft)) {
    const fs::path name = entry.path().filename();
    if (name != kRecordName) fs::rename(entry.path(), output.folder() / name);
  }
  output.commit();
}

}  // namespace castaway::testbed
