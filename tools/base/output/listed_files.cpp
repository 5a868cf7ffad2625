#include "tools/base/output/listed_files.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/output/clock_file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Entries of a folder, sorted by name.
std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// The hashes that a file may have: two while it is being replaced.
std::vector<std::string> listed_hashes(const FileRecord& record, const std::string& path) {
  std::vector<std::string> hashes;
  for (const FileHashes* files : {&record.files, &record.single_files, &record.coming}) {
    const auto found = files->find(path);
    if (found != files->end()) hashes.push_back(found->second);
  }
  return hashes;
}

/// `hashes`: not empty.
bool is_unchanged(const fs::path& file, const std::vector<std::string>& hashes) {
  std::error_code none;
  if (fs::symlink_status(file, none).type() != fs::file_type::regular) return false;
  if (hashes.front().empty()) return is_clock_file(file);
  return std::find(hashes.begin(), hashes.end(), sha256_of_file(file)) != hashes.end();
}

/// Returns "summary.json" for "summary.json.part-123", the name of a file while it is written;
/// otherwise nothing.
std::optional<std::string> name_of_part(const std::string& path) {
  constexpr std::string_view kMark = ".part-";
  const std::size_t mark = path.rfind(kMark);
  if (mark == std::string::npos) return std::nullopt;
  const std::string digits = path.substr(mark + kMark.size());
  const bool number = !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                                     [](char c) { return c >= '0' && c <= '9'; });
  return number ? std::optional<std::string>(path.substr(0, mark)) : std::nullopt;
}

bool is_part_of_list(const std::string& name) { return name_of_part(name) == kRecordName; }

/// True for what a killed process was writing: a file of the record, or the record of any folder.
bool is_leftover(const std::string& path, const FileRecord& record) {
  const auto name = name_of_part(path);
  return name && (is_part_of_list(fs::path(path).filename().string()) ||
                  !listed_hashes(record, *name).empty());
}

std::optional<ForeignFile> foreign_file(const fs::path& file, const std::string& path,
                                        const FileRecord& record) {
  const std::vector<std::string> hashes = listed_hashes(record, path);
  if (hashes.empty() && is_leftover(path, record)) return std::nullopt;
  if (hashes.empty()) return ForeignFile{path, false};
  if (!is_unchanged(file, hashes)) return ForeignFile{path, true};
  return std::nullopt;
}

std::optional<ForeignFile> find_foreign_in(const fs::path& root, const fs::path& folder,
                                           const FileRecord& record) {
  for (const fs::path& entry : sorted_entries(folder)) {
    const std::string path = entry.lexically_relative(root).generic_string();
    if (path == kRecordName || path == kStagingName) continue;
    std::error_code none;
    const bool is_folder = fs::symlink_status(entry, none).type() == fs::file_type::directory;
    if (is_folder && fs::exists(entry / kRecordName, none)) continue;
    auto found =
        is_folder ? find_foreign_in(root, entry, record) : foreign_file(entry, path, record);
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace

bool is_bookkeeping(const std::string& name) {
  return name == kRecordName || name == kStagingName || is_part_of_list(name);
}

std::optional<ForeignFile> find_foreign(const fs::path& folder,
                                        const std::optional<FileRecord>& record) {
  return find_foreign_in(folder, folder, record.value_or(FileRecord{}));
}

void clear_leftovers(const fs::path& folder) {
  for (const fs::path& entry : sorted_entries(folder)) {
    std::error_code none;
    if (is_part_of_list(entry.filename().string())) fs::remove(entry, none);
  }
}

bool is_replaceable(const fs::path& folder, const std::string& path,
                    const std::optional<FileRecord>& record) {
  std::error_code none;
  fs::path place = folder;
  for (const fs::path& part : fs::path(path).parent_path()) {
    place /= part;
    const fs::file_type type = fs::symlink_status(place, none).type();
    if (type == fs::file_type::not_found) return true;
    if (type != fs::file_type::directory) return false;
  }
  const fs::path file = folder / path;
  if (fs::symlink_status(file, none).type() == fs::file_type::not_found) return true;
  if (!record) return false;
  const std::vector<std::string> hashes = listed_hashes(*record, path);
  return !hashes.empty() && is_unchanged(file, hashes);
}

FileRecord settle(const fs::path& folder, FileRecord record) {
  for (const auto& [path, hash] : std::exchange(record.coming, {})) {
    FileRecord one;
    one.files[path] = hash;
    if (!fs::exists(folder / path) || !is_replaceable(folder, path, one)) continue;
    const bool single = record.finished && !record.files.contains(path);
    (single ? record.single_files : record.files)[path] = hash;
  }
  return record;
}

}  // namespace castaway::testbed
