#include "tools/batch/dataset/dataset_folder.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/durable.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"
#include "tools/batch/dataset/dataset_manifest.hpp"
#include "tools/batch/jobs/job_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string identity_text(const DatasetIdentity& identity) {
  const Json root{
      {"castaway", identity.version}, {"seed", identity.seed}, {"sequences", identity.sequences}};
  return json_text(root, 1) + "\n";
}

/// Describes the first line in which two texts differ.
std::string first_difference(const std::string& there, const std::string& here) {
  std::istringstream old_text(there);
  std::istringstream new_text(here);
  std::string a;
  std::string b;
  for (int line = 1;; ++line) {
    const bool more_a = static_cast<bool>(std::getline(old_text, a));
    const bool more_b = static_cast<bool>(std::getline(new_text, b));
    if (more_a && more_b && a == b) continue;
    const auto shown = [](bool more, const std::string& text) {
      const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
      return more ? "'" + text.substr(begin) + "'" : "nothing";
    };
    return fmt::format("line {} of its dataset.yaml is {}, now it would be {}", line,
                       shown(more_a, a), shown(more_b, b));
  }
}

constexpr const char* kMadeBy = "dataset";
constexpr const char* kWork = ".work";  // Folder of drafts; that of a shard begins so.

/// The card and the tables of a finished data set that are there. Throws std::runtime_error unless
/// they are still ours.
std::vector<std::string> unchanged_tables(const fs::path& folder) {
  const std::vector<ManifestFile> listed = read_manifest(folder / "manifest.json");
  const fs::path sums = folder / "SHA256SUMS";
  if (fs::exists(sums) && read_file(sums) != sums_text(listed)) {
    refuse_folder(folder, "'SHA256SUMS' was changed since castaway wrote it");
  }
  std::vector<std::string> tables{"SHA256SUMS"};
  for (const ManifestFile& file : listed) {
    if (file.path.starts_with("sequences/") || !fs::exists(folder / file.path)) continue;
    require_no_link(folder, file.path);
    if (sha256_of_file(folder / file.path) != file.sha256) {
      refuse_folder(folder, fmt::format("'{}' was changed since castaway wrote it", file.path));
    }
    tables.push_back(file.path);
  }
  return tables;
}

/// Removes what a finished data set has beside its sequences before it grows, the manifest last.
void clear_tables(const fs::path& folder) {
  if (!fs::exists(folder / "manifest.json")) return;
  std::vector<std::string> tables = unchanged_tables(folder);
  std::erase_if(tables, [](const std::string& path) { return path.starts_with("dataset."); });
  tables.emplace_back("manifest.json");
  std::error_code none;
  for (const std::string& path : tables) fs::remove(folder / path, none);
}

/// What differs between the data set of a folder and another one.
std::string dataset_difference(const fs::path& folder, const Json& there,
                               const DatasetIdentity& identity) {
  const auto seed = integer_or(there, "seed", std::uint64_t{0});
  if (seed != identity.seed) {
    return fmt::format("was made with seed {}, not {}", seed, identity.seed);
  }
  const std::string spec = read_file(folder / "dataset.yaml");
  if (spec != identity.spec) {
    return "was made from another specification: " + first_difference(spec, identity.spec);
  }
  const int sequences = integer_or(there, "sequences", 0);
  if (sequences <= identity.sequences) return "";
  return fmt::format("has {} sequences, more than {}", sequences, identity.sequences);
}

}  // namespace

void check_identity(const fs::path& folder, const DatasetIdentity& identity) {
  for (const char* place : {"manifest.json", "SHA256SUMS", "sequences"}) {
    require_no_link(folder, place);
  }
  check_folder(folder, {kMadeBy, "data set", identity.version, [&](const Json& there) {
                          return dataset_difference(folder, there, identity);
                        }});
}

DatasetFolder::DatasetFolder(fs::path folder, const DatasetIdentity& identity, Shard shard)
    : folder_(std::move(folder)), shard_(shard) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();
  check_identity(folder_, identity);
  make_folder(folder_);
  whole_.emplace(folder_, kPatience);
  begin(identity);
  if (!shard_.is_all()) whole_.reset();  // Other shards go on.
}

void DatasetFolder::begin(const DatasetIdentity& identity) {
  const bool begun = fs::exists(folder_ / "dataset.json");
  if (begun) {
    check_identity(folder_, identity);  // Another process may have begun in between.
  } else {
    whole_->record() = {kMadeBy, {}, false, {}, {{"dataset.yaml", sha256(identity.spec)}}};
    whole_->save();
  }
  clear_drafts();
  const std::string text = identity_text(identity);
  if (!begun || read_file(folder_ / "dataset.json") != text) {
    clear_tables(folder_);
    put("dataset.yaml", identity.spec);
    put("dataset.json", text);
  }
  fs::create_directories(folder_ / "sequences");
  std::error_code none;  // From here on, dataset.json says whose folder it is.
  fs::remove(folder_ / kRecordName, none);
}

fs::path DatasetFolder::work() const {
  return folder_ /
         (shard_.is_all() ? kWork : fmt::format("{}-{}-of-{}", kWork, shard_.index, shard_.count));
}

void DatasetFolder::clear_drafts() {
  if (!shard_.is_all()) {
    require_no_link(folder_, work().filename());
    fs::create_directories(work());
    share_.emplace(work());
    for (const auto& entry : fs::directory_iterator(work())) fs::remove_all(entry);
    return;
  }
  clear_work();
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (!entry.path().filename().string().starts_with(std::string(kWork) + "-")) continue;
    const FolderLock none_works_there(entry.path());
    fs::remove_all(entry.path());
  }
}

bool DatasetFolder::is_finished() const { return fs::exists(folder_ / "manifest.json"); }

bool DatasetFolder::has_sequence(const std::string& name) const {
  return fs::exists(sequence(name));
}

fs::path DatasetFolder::sequence(const std::string& name) const {
  return folder_ / "sequences" / name;
}

fs::path DatasetFolder::draft(const std::string& name) const { return work() / name; }

void DatasetFolder::commit_sequence(const std::string& name) const {
  move_durable(draft(name), sequence(name));
}

void DatasetFolder::put(const std::string& path, std::string_view bytes) const {
  require_no_link(folder_, path);
  write_durable(work() / "file", folder_ / path, bytes);
}

void DatasetFolder::put_new(const std::string& path, std::string_view bytes) const {
  if (fs::exists(folder_ / path) && read_file(folder_ / path) != bytes) {
    throw std::runtime_error(
        (folder_ / path).string() +
        ": castaway did not write what is there; move it away and repeat the command");
  }
  put(path, bytes);
}

void DatasetFolder::clear_work() const {
  std::error_code error;
  fs::remove_all(work(), error);
  if (error) {
    throw FileError(fmt::format("{}: cannot be removed ({})", work().string(), error.message()));
  }
}

}  // namespace castaway::testbed
