#include "tools/base/output/own_file.hpp"

#include <stdexcept>

#include "tools/base/files/durable.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/output/file_record.hpp"
#include "tools/base/output/folder_lock.hpp"
#include "tools/base/output/listed_files.hpp"
#include "tools/base/output/make_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

constexpr double kLockWait = 10.0;  // [s] Other processes hold the lock only briefly.

void require_own(const fs::path& file, const std::optional<FileRecord>& record) {
  if (!file.has_filename()) {
    throw std::runtime_error(file.string() + ": names a folder; give a file's name");
  }
  if (is_replaceable(folder_of(file), file.filename().string(), record)) return;
  throw std::runtime_error(file.string() +
                           ": exists, and castaway did not write it or it was changed since; move "
                           "it away or give another name");
}

/// The hidden folder of drafts in a locked folder, which is removed with all that is in it. The
/// list comes first: it says whose the folder of drafts is. A new list goes, too, unless
/// `keep_list` is called.
class Drafts {
 public:
  Drafts(const fs::path& folder, const std::optional<FileRecord>& record)
      : place_(folder / kStagingName), new_list_(!record) {
    if (new_list_) {
      if (fs::exists(fs::symlink_status(place_))) {
        throw std::runtime_error(place_.string() +
                                 ": castaway did not make it; move it away or name another folder");
      }
      save_record(folder, {});
    }
    fs::remove_all(place_);
    make_folder(place_);
  }
  ~Drafts() {
    std::error_code none;
    fs::remove_all(place_, none);
    if (new_list_) fs::remove(place_.parent_path() / kRecordName, none);
  }
  Drafts(const Drafts&) = delete;
  Drafts& operator=(const Drafts&) = delete;
  [[nodiscard]] const fs::path& folder() const { return place_; }
  void keep_list() { new_list_ = false; }

 private:
  fs::path place_;
  bool new_list_ = false;
};

/// Lists the file as coming before it comes, so that its list is right whenever the process ends.
void move_own_file(const fs::path& draft, const fs::path& file, FileRecord record) {
  const fs::path folder = folder_of(file);
  const std::string name = file.filename().string();
  const std::string hash = hash_file(draft.parent_path(), name);
  record.coming[name] = hash;
  save_record(folder, record);
  std::error_code error;
  fs::rename(draft, file, error);
  if (error) throw FileError(file.string() + ": cannot be written (" + error.message() + ")");
  record.coming.clear();
  FileHashes& files = record.files.contains(name) ? record.files : record.single_files;
  files[name] = hash;
  save_record(folder, record);
}

}  // namespace

void require_own_file(const fs::path& file) { require_own(file, load_record(folder_of(file))); }

void put_own_file(const fs::path& file, const std::function<void(const fs::path& draft)>& write) {
  const fs::path folder = folder_of(file);
  std::error_code error;
  fs::create_directories(folder, error);  // If this fails, the lock reports the error.
  const FolderLock lock(folder, kLockWait);
  std::optional<FileRecord> record = load_record(folder);
  if (record) record = settle(folder, std::move(*record));
  require_own(file, record);
  clear_leftovers(folder);
  Drafts drafts(folder, record);
  const fs::path draft = drafts.folder() / file.filename();
  write(draft);
  drafts.keep_list();
  move_own_file(draft, file, record.value_or(FileRecord{}));
}

void write_own_file(const fs::path& file, std::string_view bytes) {
  put_own_file(file, [&](const fs::path& draft) { write_file(draft, bytes); });
}

}  // namespace castaway::testbed
