#include "tools/base/output/own_file.hpp"

#include <stdexcept>

#include "tools/base/files/durable.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/listed_files.hpp"
#include "tools/base/output/work_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

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

void put_own_file(const fs::path& file, const std::function<void(const fs::path& draft)>& write) {
  const fs::path folder = folder_of(file);
  std::error_code error;
  fs::create_directories(folder, error);  // If this fails, the lock reports the error.
  WorkFolder work(folder, kPatience);
  FileRecord& record = work.record();
  require_own(file, record);
  work.begin({});
  const std::string name = file.filename().string();
  const std::string hash = work.put(name, write);
  (record.files.contains(name) ? record.files : record.single_files)[name] = hash;
  work.save();
}

void write_own_file(const fs::path& file, std::string_view bytes) {
  put_own_file(file, [&](const fs::path& draft) { write_file(draft, bytes); });
}

}  // namespace castaway::testbed
