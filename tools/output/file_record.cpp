#include "tools/output/file_record.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/files/file.hpp"
#include "tools/files/sha256.hpp"
#include "tools/formats/json_file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxRecordBytes = 64 * 1024 * 1024;
constexpr std::array<const char*, 3> kClockFiles{"report.html", "timing.csv", "timing.json"};

bool holds_clock_readings(const std::string& path) {
  return std::find(kClockFiles.begin(), kClockFiles.end(), path) != kClockFiles.end();
}

Json to_json(const FileHashes& files) {
  Json object = Json::object();
  for (const auto& [path, hash] : files) object[path] = hash.empty() ? Json(nullptr) : Json(hash);
  return object;
}

FileHashes hashes_of(const Json& root, const char* key) {
  FileHashes files;
  if (!root.contains(key)) return files;
  for (const auto& [path, hash] : root.at(key).items()) {
    files[path] = hash.is_null() ? "" : hash.get<std::string>();
  }
  return files;
}

FileRecord from_json(const Json& root) {
  FileRecord record;
  record.made_by = root.value("made_by", std::string());
  record.settings = root.value("settings", std::string());
  record.finished = root.value("finished", true);
  record.program = root.value("program", std::string());
  record.files = hashes_of(root, "files");
  record.single_files = hashes_of(root, "single_files");
  if (root.contains("runs")) record.runs = root.at("runs").get<std::vector<std::string>>();
  return record;
}

/// Entries of a folder, sorted by name.
std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

const std::string* listed_hash(const FileRecord& record, const std::string& path) {
  for (const FileHashes* files : {&record.files, &record.single_files}) {
    const auto found = files->find(path);
    if (found != files->end()) return &found->second;
  }
  return nullptr;
}

bool is_unchanged(const fs::path& file, const std::string& hash) {
  std::error_code none;
  if (fs::symlink_status(file, none).type() != fs::file_type::regular) return false;
  return hash.empty() || sha256_of_file(file) == hash;
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

/// True for what a killed process was writing: a file of the record, or the record of any folder.
bool is_leftover(const std::string& path, const FileRecord& record) {
  const auto name = name_of_part(path);
  return name &&
         (fs::path(*name).filename() == kRecordName || listed_hash(record, *name) != nullptr);
}

std::optional<ForeignFile> foreign_file(const fs::path& file, const std::string& path,
                                        const FileRecord& record) {
  const std::string* hash = listed_hash(record, path);
  if (hash == nullptr && is_leftover(path, record)) return std::nullopt;
  if (hash == nullptr) return ForeignFile{path, false};
  if (!is_unchanged(file, *hash)) return ForeignFile{path, true};
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

std::optional<FileRecord> load_record(const fs::path& folder) {
  const fs::path file = folder / kRecordName;
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  try {
    if (fs::file_size(file) > kMaxRecordBytes) throw std::runtime_error("too long");
    const Json root = read_json(file);
    if (!root.is_object() || !root.contains("castaway")) throw std::runtime_error("no list");
    return from_json(root);
  } catch (const std::exception&) {
    throw std::runtime_error(
        file.string() +
        ": is not castaway's list of the files that it wrote; choose another folder");
  }
}

void save_record(const fs::path& folder, const FileRecord& record) {
  Json root{{"castaway", CASTAWAY_VERSION}};
  if (!record.made_by.empty()) root["made_by"] = record.made_by;
  if (!record.settings.empty()) root["settings"] = record.settings;
  root["finished"] = record.finished;
  if (!record.program.empty()) root["program"] = record.program;
  root["files"] = to_json(record.files);
  if (!record.single_files.empty()) root["single_files"] = to_json(record.single_files);
  if (!record.runs.empty()) root["runs"] = record.runs;
  write_file(folder / kRecordName, root.dump(1) + "\n");
}

std::string hash_file(const fs::path& folder, const std::string& path) {
  return holds_clock_readings(path) ? "" : sha256_of_file(folder / path);
}

FileHashes hash_files(const fs::path& folder) {
  FileHashes files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    if (path != kRecordName) files[path] = hash_file(folder, path);
  }
  return files;
}

std::optional<ForeignFile> find_foreign(const fs::path& folder,
                                        const std::optional<FileRecord>& record) {
  return find_foreign_in(folder, folder, record.value_or(FileRecord{}));
}

void clear_leftovers(const fs::path& folder, const std::optional<FileRecord>& record) {
  for (const fs::path& entry : sorted_entries(folder)) {
    std::error_code none;
    const std::string name = entry.filename().string();
    if (is_leftover(name, record.value_or(FileRecord{}))) fs::remove(entry, none);
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
  const std::string* hash = record ? listed_hash(*record, path) : nullptr;
  return hash != nullptr && is_unchanged(file, *hash);
}

}  // namespace castaway::testbed
