#include "tools/batch/jobs/job_folder.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/file_record.hpp"
#include "tools/base/output/listed_files.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/runs_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string marker_of(const std::string& kind) { return kind + ".json"; }
std::string specification_of(const std::string& kind) { return kind + ".yaml"; }

Json identity_json(const JobIdentity& identity) {
  return {{"castaway", identity.version},
          {"kind", identity.kind},
          {"program", identity.program},
          {"data", identity.data},
          {"spec", sha256(identity.spec)}};
}

/// What differs between the batch of a folder and another one.
std::string job_difference(const Json& there, const JobIdentity& identity) {
  const Json here = identity_json(identity);
  if (there == here) return "";
  if (there.value("program", "") != identity.program) return "was made by another build";
  if (there.value("spec", "") != here.at("spec")) {
    return "was made from another specification, its " + specification_of(identity.kind);
  }
  return "was made with other worlds, robots or logs: their files have changed since";
}

/// Throws std::runtime_error if the specification was changed since the marker was written.
void require_specification(const fs::path& folder, const JobIdentity& identity) {
  const fs::path file = folder / specification_of(identity.kind);
  std::error_code none;
  if (!fs::exists(file, none) || read_file(file) == identity.spec) return;
  throw std::runtime_error(file.string() +
                           ": was changed since castaway wrote it; remove it, and it is made anew");
}

/// A folder without a marker may hold only what an unfinished beginning left there.
void check_unused(const fs::path& folder, const FolderMark& mark) {
  std::optional<FileRecord> record = load_record(folder);
  if (record && record->made_by != mark.kind) record.reset();
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    const bool own = record && (name.starts_with(".work") || is_replaceable(folder, name, record));
    if (own || is_bookkeeping(name)) continue;
    refuse_folder(folder, fmt::format("holds '{}' and no {}", name, mark.name));
  }
}

}  // namespace

JobIdentity identity_of_this_program(std::string kind, std::string data, std::string spec) {
  return {std::move(kind), CASTAWAY_VERSION, program_hash(), std::move(data), std::move(spec)};
}

void check_folder(const fs::path& folder, const FolderMark& mark) {
  for (const auto& name : {marker_of(mark.kind), specification_of(mark.kind)}) {
    require_no_link(folder, name);
  }
  std::error_code none;
  if (fs::exists(folder, none) && !fs::is_directory(folder, none)) {
    refuse_folder(folder, "is no folder");
  }
  const std::string marker = marker_of(mark.kind);
  if (!fs::exists(folder / marker, none)) return check_unused(folder, mark);
  const std::string text = read_file(folder / marker);
  const Json there = nests_too_deep(text) ? Json() : Json::parse(text, nullptr, false);
  const std::string version = there.is_object() ? there.value("castaway", "") : "";
  if (version.empty()) refuse_folder(folder, fmt::format("its {} is not castaway's", marker));
  const std::string difference =
      version == mark.version
          ? mark.difference(there)
          : fmt::format("was made by castaway {}, this is {}", version, mark.version);
  if (!difference.empty()) refuse_folder(folder, difference);
}

JobFolder::JobFolder(fs::path folder, const JobIdentity& identity) : folder_(std::move(folder)) {
  check_folder(folder_, {identity.kind, identity.kind, identity.version,
                         [&](const Json& there) { return job_difference(there, identity); }});
  require_specification(folder_, identity);
  make_folder(folder_);
  // The marker comes first: whatever follows is the batch's.
  for (const auto& [name, text] :
       {std::pair(marker_of(identity.kind), json_text(identity_json(identity), 1) + "\n"),
        std::pair(specification_of(identity.kind), identity.spec)}) {
    if (!fs::exists(folder_ / name)) write_own_file(folder_ / name, text);
  }
}

void JobFolder::put(const std::string& name,
                    const std::function<void(const fs::path& draft)>& write) const {
  put_own_file(folder_ / name, write);
}

void JobFolder::put(const std::string& name, const std::string& text) const {
  put(name, [&](const fs::path& file) { write_file(file, text); });
}

void require_job_folder(const fs::path& folder, const std::string& kind) {
  std::error_code none;
  if (fs::exists(folder / marker_of(kind), none)) return;
  throw std::runtime_error(
      fmt::format("{}: is no folder of this kind: it has no {}", folder.string(), marker_of(kind)));
}

}  // namespace castaway::testbed
