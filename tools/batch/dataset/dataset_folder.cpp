#include "tools/batch/dataset/dataset_folder.hpp"

#include <algorithm>
#include <optional>
#include <set>
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
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/file_record.hpp"
#include "tools/base/output/listed_files.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"
#include "tools/batch/dataset/dataset_manifest.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string identity_text(const DatasetIdentity& identity) {
  const Json root{
      {"castaway", identity.version}, {"seed", identity.seed}, {"sequences", identity.sequences}};
  return json_text(root, 1) + "\n";
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw std::runtime_error(
      fmt::format("{}: {}; choose another folder with --out", folder.string(), why));
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
constexpr double kLockTimeout = 10.0;   // [s]

/// A folder without a data set may hold only what an unfinished attempt of castaway left there.
void check_unused(const fs::path& folder) {
  const std::optional<FileRecord> record = load_record(folder);
  std::set<std::string> own;
  if (record && record->made_by == kMadeBy) {
    own.insert("sequences");
    if (is_replaceable(folder, "dataset.yaml", record)) own.insert("dataset.yaml");
  }
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    const bool draft = record && record->made_by == kMadeBy && name.starts_with(kWork);
    if (own.contains(name) || draft || is_bookkeeping(name)) continue;
    refuse(folder, fmt::format("holds '{}' and no data set", name));
  }
}

/// The card and the tables of a finished data set that are there. Throws std::runtime_error unless
/// they are still ours.
std::vector<std::string> unchanged_tables(const fs::path& folder) {
  const std::vector<ManifestFile> listed = read_manifest(folder / "manifest.json");
  const fs::path sums = folder / "SHA256SUMS";
  if (fs::exists(sums) && read_file(sums) != sums_text(listed)) {
    refuse(folder, "'SHA256SUMS' was changed since castaway wrote it");
  }
  std::vector<std::string> tables{"SHA256SUMS"};
  for (const ManifestFile& file : listed) {
    if (file.path.starts_with("sequences/") || !fs::exists(folder / file.path)) continue;
    require_no_link(folder, file.path);
    if (sha256_of_file(folder / file.path) != file.sha256) {
      refuse(folder, fmt::format("'{}' was changed since castaway wrote it", file.path));
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

/// Throws std::runtime_error if a place of the folder is a link.
void require_own_places(const fs::path& folder) {
  for (const char* place :
       {"dataset.json", "dataset.yaml", "manifest.json", "SHA256SUMS", "sequences"}) {
    require_no_link(folder, place);
  }
}

}  // namespace

void check_identity(const fs::path& folder, const DatasetIdentity& identity) {
  std::error_code none;
  if (fs::exists(folder, none) && !fs::is_directory(folder, none)) refuse(folder, "is no folder");
  if (!fs::exists(folder / "dataset.json", none)) return check_unused(folder);
  const std::string text = read_file(folder / "dataset.json");
  const Json root = nests_too_deep(text) ? Json() : Json::parse(text, nullptr, false);
  if (!root.is_object()) refuse(folder, "its dataset.json cannot be read");
  const auto version = root.value("castaway", std::string());
  if (version != identity.version) {
    refuse(folder, fmt::format("was made by castaway {}, this is {}", version, identity.version));
  }
  const auto seed = integer_or(root, "seed", std::uint64_t{0});
  if (seed != identity.seed) {
    refuse(folder, fmt::format("was made with seed {}, not {}", seed, identity.seed));
  }
  const std::string spec = read_file(folder / "dataset.yaml");
  if (spec != identity.spec) {
    refuse(folder, "was made from another specification: " + first_difference(spec, identity.spec));
  }
  const int sequences = integer_or(root, "sequences", 0);
  if (sequences > identity.sequences) {
    refuse(folder, fmt::format("has {} sequences, more than {}", sequences, identity.sequences));
  }
}

DatasetFolder::DatasetFolder(fs::path folder, const DatasetIdentity& identity, Shard shard)
    : folder_(std::move(folder)), shard_(shard) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();
  require_own_places(folder_);
  check_identity(folder_, identity);
  make_folder(folder_);
  lock_.emplace(folder_, kLockTimeout);
  if (shard_.is_all()) clear_work_of_shards();
  begin(identity);
  if (shard_.is_all()) return;
  fs::create_directories(work());
  lock_.emplace(work());  // Other shards go on.
}

void DatasetFolder::begin(const DatasetIdentity& identity) const {
  const bool begun = fs::exists(folder_ / "dataset.json");
  if (!begun) {
    save_record(folder_, {kMadeBy, {}, false, {}, {{"dataset.yaml", sha256(identity.spec)}}});
  }
  clear_leftovers(folder_);
  if (shard_.is_all() || !fs::exists(work())) {
    clear_work();
  } else {
    const FolderLock own(work());
    clear_work();
  }
  fs::create_directories(folder_ / "sequences");
  const std::string text = identity_text(identity);
  if (!begun || read_file(folder_ / "dataset.json") != text) {
    clear_tables(folder_);
    put("dataset.yaml", identity.spec);
    put("dataset.json", text);
  }
  std::error_code none;  // From here on, dataset.json says whose folder it is.
  fs::remove(folder_ / kRecordName, none);
}

fs::path DatasetFolder::work() const {
  return folder_ /
         (shard_.is_all() ? kWork : fmt::format("{}-{}-of-{}", kWork, shard_.index, shard_.count));
}

void DatasetFolder::clear_work_of_shards() const {
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
