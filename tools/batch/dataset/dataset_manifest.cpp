#include "tools/batch/dataset/dataset_manifest.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/file_record.hpp"
#include "tools/base/output/listed_path.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The lists themselves, and the file that depends on the build.
const std::set<std::string> kUnlisted{"manifest.json", "SHA256SUMS", kPlotsPage};

/// Sorted paths relative to the folder.
std::vector<std::string> paths_in(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory() && !entry.is_symlink()) continue;
    if (entry.path().filename() == kRecordName) continue;
    paths.push_back(entry.path().lexically_relative(folder).generic_string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Describes what is wrong with a listed file; empty if it is correct.
std::string error_in(const fs::path& folder, const ManifestFile& file) {
  const fs::path path = folder / file.path;
  std::error_code error;
  if (find_link(folder, file.path)) return fmt::format("{}: is reached by a link", file.path);
  if (!fs::is_regular_file(path, error)) return fmt::format("{}: missing", file.path);
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (bytes != file.bytes) {
    return fmt::format("{}: changed: {} bytes instead of {}", file.path, bytes, file.bytes);
  }
  const std::string sum = sha256_of_file(path);
  if (sum == file.sha256) return "";
  return fmt::format("{}: changed: SHA-256 {}... instead of {}...", file.path, sum.substr(0, 12),
                     file.sha256.substr(0, 12));
}

}  // namespace

std::vector<ManifestFile> survey_files(const fs::path& folder) {
  std::vector<ManifestFile> files;
  for (const std::string& path : paths_in(folder)) {
    files.push_back({path, fs::file_size(folder / path), sha256_of_file(folder / path)});
  }
  return files;
}

std::string manifest_text(const std::vector<ManifestFile>& files) {
  Json list = Json::array();
  std::uintmax_t bytes = 0;
  for (const ManifestFile& file : files) {
    list.push_back({{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
    bytes += file.bytes;
  }
  const Json root{{"castaway", CASTAWAY_VERSION}, {"bytes", bytes}, {"files", std::move(list)}};
  return json_text(root, 1) + "\n";
}

std::string sums_text(const std::vector<ManifestFile>& files) {
  std::string text;
  for (const ManifestFile& file : files) text += file.sha256 + "  " + file.path + "\n";
  return text;
}

std::vector<ManifestFile> read_manifest(const fs::path& file) {
  try {
    std::vector<ManifestFile> files;
    const std::string text = read_file(file);
    const Json root = nests_too_deep(text) ? Json() : Json::parse(text);
    for (const Json& entry : root.at("files")) {
      const auto path = entry.at("path").get<std::string>();
      require_listed_path(file, path);
      files.push_back(
          {path, entry.at("bytes").get<std::uintmax_t>(), entry.at("sha256").get<std::string>()});
    }
    return files;
  } catch (const Json::exception& error) {
    throw std::runtime_error(
        fmt::format("{}: no manifest of a data set: {}", file.string(), error.what()));
  }
}

std::vector<std::string> verify_dataset(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "manifest.json")) {
    throw std::runtime_error(
        fmt::format("{}: no manifest.json: not a data set, or an unfinished one; repeat the "
                    "command that made it to finish it",
                    folder.string()));
  }
  const std::vector<ManifestFile> files = read_manifest(folder / "manifest.json");
  std::vector<std::string> troubles;
  std::set<std::string> listed = kUnlisted;
  for (const ManifestFile& file : files) {
    listed.insert(file.path);
    const std::string trouble = error_in(folder, file);
    if (!trouble.empty()) troubles.push_back(trouble);
  }
  if (!fs::is_regular_file(folder / "SHA256SUMS")) {
    troubles.emplace_back("SHA256SUMS: missing");
  } else if (read_file(folder / "SHA256SUMS") != sums_text(files)) {
    troubles.emplace_back("SHA256SUMS: changed: it does not agree with manifest.json");
  }
  for (const std::string& path : paths_in(folder)) {
    if (!listed.contains(path)) troubles.push_back(path + ": not listed in manifest.json");
  }
  return troubles;
}

}  // namespace castaway::testbed
