#include "tools/base/output/own_file.hpp"

#include <stdexcept>

#include "tools/base/files/durable.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/file_record.hpp"
#include "tools/base/output/folder_lock.hpp"
#include "tools/base/output/listed_files.hpp"

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

}  // namespace

void require_own_file(const fs::path& file) { require_own(file, load_record(folder_of(file))); }

void put_own_file(const fs::path& file, const std::function<void()>& put) {
  const fs::path folder = folder_of(file);
  std::error_code error;
  fs::create_directories(folder, error);  // If this fails, the lock reports the error.
  const FolderLock lock(folder, kLockWait);
  const std::optional<FileRecord> known = load_record(folder);
  require_own(file, known);
  put();
  FileRecord record = known.value_or(FileRecord{});
  const std::string name = file.filename().string();
  FileHashes& files = record.files.contains(name) ? record.files : record.single_files;
  files[name] = hash_file(folder, name);
  save_record(folder, record);
}

void write_own_file(const fs::path& file, std::string_view bytes) {
  put_own_file(file, [&] { write_file(file, bytes); });
}

}  // namespace castaway::testbed
