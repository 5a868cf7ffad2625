#include "tools/base/output/file_record.hpp"

#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/clock_file.hpp"
#include "tools/base/output/listed_path.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxRecordBytes = 64 * 1024 * 1024;

bool is_hash(const std::string& text) {
  constexpr std::size_t kDigits = 64;
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

Json to_json(const FileHashes& files) {
  Json object = Json::object();
  for (const auto& [path, hash] : files) object[path] = hash.empty() ? Json(nullptr) : Json(hash);
  return object;
}

FileHashes hashes_of(const Json& root, const char* key) {
  FileHashes files;
  if (!root.contains(key)) return files;
  if (!root.at(key).is_object()) throw std::runtime_error(fmt::format("'{}' is no object", key));
  for (const auto& [path, hash] : root.at(key).items()) {
    const std::string digits = hash.is_null() ? "" : hash.get<std::string>();
    const bool good = hash.is_null() ? holds_clock_readings(path) : is_hash(digits);
    if (!good) throw std::runtime_error(fmt::format("'{}' has no SHA-256", path));
    files[path] = digits;
  }
  return files;
}

/// Throws std::runtime_error if a path leads out of the folder.
void check_paths(const fs::path& list, const FileRecord& record) {
  for (const FileHashes* files : {&record.files, &record.single_files, &record.coming}) {
    for (const auto& [path, hash] : *files) require_listed_path(list, path);
  }
  for (const std::string& run : record.runs) require_listed_path(list, run);
}

FileRecord from_json(const Json& root) {
  if (!root.is_object() || !root.contains("castaway")) throw std::runtime_error("no list");
  FileRecord record;
  record.made_by = root.value("made_by", std::string());
  record.settings = root.value("settings", std::string());
  record.finished = root.value("finished", true);
  record.program = root.value("program", std::string());
  record.files = hashes_of(root, "files");
  record.single_files = hashes_of(root, "single_files");
  record.coming = hashes_of(root, "coming");
  if (root.contains("runs")) record.runs = root.at("runs").get<std::vector<std::string>>();
  return record;
}

}  // namespace

std::optional<FileRecord> load_record(const fs::path& folder) {
  const fs::path file = folder / kRecordName;
  std::error_code none;
  if (!fs::exists(fs::symlink_status(file, none))) return std::nullopt;
  require_no_link(folder, kRecordName);
  FileRecord record;
  try {
    if (fs::file_size(file) > kMaxRecordBytes) throw std::runtime_error("too long");
    record = from_json(read_json(file));
  } catch (const std::exception&) {
    throw std::runtime_error(
        file.string() +
        ": is not castaway's list of the files that it wrote; choose another folder");
  }
  check_paths(file, record);
  return record;
}

void save_record(const fs::path& folder, const FileRecord& record) {
  Json root{{"castaway", CASTAWAY_VERSION}};
  if (!record.made_by.empty()) root["made_by"] = record.made_by;
  if (!record.settings.empty()) root["settings"] = record.settings;
  root["finished"] = record.finished;
  if (!record.program.empty()) root["program"] = record.program;
  root["files"] = to_json(record.files);
  if (!record.single_files.empty()) root["single_files"] = to_json(record.single_files);
  if (!record.coming.empty()) root["coming"] = to_json(record.coming);
  if (!record.runs.empty()) root["runs"] = record.runs;
  write_file(folder / kRecordName, json_text(root, 1) + "\n");
}

std::string hash_file(const fs::path& folder, const std::string& path) {
  return holds_clock_readings(path) ? "" : sha256_of_file(folder / path);
}

FileHashes hash_files(const fs::path& folder) {
  FileHashes files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.symlink_status().type() != fs::file_type::regular) continue;
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    if (path != kRecordName) files[path] = hash_file(folder, path);
  }
  return files;
}

}  // namespace castaway::testbed
