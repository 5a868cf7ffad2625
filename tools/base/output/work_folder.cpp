#include "tools/base/output/work_folder.hpp"

#include <stdexcept>
#include <utility>

#include "tools/base/files/file_error.hpp"
#include "tools/base/output/listed_files.hpp"
#include "tools/base/output/make_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// True for the list of a process that was killed before it wrote anything.
bool says_nothing(const FileRecord& record) {
  return !record.finished && record.files.empty() && record.single_files.empty() &&
         record.runs.empty();
}

}  // namespace

WorkFolder::WorkFolder(fs::path folder, double patience_s)
    : folder_(std::move(folder)), drafts_(folder_ / kStagingName), lock_(folder_, patience_s) {
  if (auto record = load_record(folder_)) {
    record_ = settle(folder_, std::move(*record));
    is_new_ = says_nothing(record_);
  } else if (fs::exists(fs::symlink_status(drafts_))) {
    throw std::runtime_error(drafts_.string() +
                             ": castaway did not make it; move it away or name another folder");
  }
  clear_leftovers(folder_);
}

WorkFolder::~WorkFolder() {
  std::error_code none;
  fs::remove_all(drafts_, none);
  if (is_new_) fs::remove(folder_ / kRecordName, none);
}

void WorkFolder::begin(const FileRecord& first) {
  if (is_new_) {
    record_ = first;
    save_record(folder_, record_);
  }
  fs::remove_all(drafts_);
  make_folder(drafts_);
}

void WorkFolder::save() {
  is_new_ = false;
  save_record(folder_, record_);
}

void WorkFolder::require_replaceable(const FileHashes& files) const {
  for (const auto& [path, hash] : files) {
    if (is_replaceable(folder_, path, record_)) continue;
    throw std::runtime_error(
        (folder_ / path).string() +
        ": castaway did not write what is there; move it away or choose another --out");
  }
}

void WorkFolder::move_in(const FileHashes& files) {
  record_.coming = files;
  save();
  for (const auto& [path, hash] : files) {
    const fs::path place = folder_ / path;
    fs::create_directories(place.parent_path());
    std::error_code error;
    fs::rename(drafts_ / path, place, error);
    if (error) throw FileError(place.string() + ": cannot be written (" + error.message() + ")");
  }
  record_.coming.clear();
}

std::string WorkFolder::put(const std::string& name,
                            const std::function<void(const fs::path& draft)>& write) {
  require_replaceable({{name, ""}});
  write(drafts_ / name);
  std::string hash = hash_file(drafts_, name);
  move_in({{name, hash}});
  return hash;
}

}  // namespace castaway::testbed
