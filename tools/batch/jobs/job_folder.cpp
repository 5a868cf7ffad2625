#include "tools/batch/jobs/job_folder.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
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

[[noreturn]] void refuse_folder(const fs::path& folder, const std::string& why) {
  throw std::runtime_error(
      fmt::format("{}: {}; choose another folder with --out", folder.string(), why));
}

Json identity_json(const JobIdentity& identity) {
  return {{"castaway", identity.version},
          {"kind", identity.kind},
          {"program", identity.program},
          {"data", identity.data},
          {"spec", sha256(identity.spec)}};
}

/// What differs between the batch of a folder and another one.
std::string difference_of(const Json& there, const Json& here) {
  if (there.value("castaway", "") != here.at("castaway")) {
    return fmt::format("was made by castaway {}, this is {}", there.value("castaway", "?"),
                       here.at("castaway").get<std::string>());
  }
  if (there.value("program", "") != here.at("program")) return "was made by another build";
  if (there.value("spec", "") != here.at("spec")) {
    return "was made from another specification, its " +
           specification_of(here.at("kind").get<std::string>());
  }
  return "was made with other worlds, robots or logs: their files have changed since";
}

void check_marker(const fs::path& folder, const JobIdentity& identity) {
  const Json here = identity_json(identity);
  const Json there = read_json(folder / marker_of(identity.kind));
  if (!there.is_object() || there.value("kind", "") != identity.kind) {
    refuse_folder(folder, fmt::format("its {} is not castaway's", marker_of(identity.kind)));
  }
  if (there != here) refuse_folder(folder, difference_of(there, here));
  const fs::path file = folder / specification_of(identity.kind);
  std::error_code none;
  if (fs::exists(file, none) && read_file(file) != identity.spec) {
    throw std::runtime_error(
        file.string() + ": was changed since castaway wrote it; remove it, and it is made anew");
  }
}

void check_same_batch(const fs::path& folder, const JobIdentity& identity) {
  std::error_code none;
  for (const auto& name : {marker_of(identity.kind), specification_of(identity.kind)}) {
    require_no_link(folder, name);
  }
  if (fs::exists(folder, none) && !fs::is_directory(folder, none)) {
    refuse_folder(folder, "is no folder");
  }
  if (fs::exists(folder / marker_of(identity.kind), none)) return check_marker(folder, identity);
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (is_bookkeeping(name)) continue;
    refuse_folder(folder, fmt::format("holds '{}' and no {}", name, identity.kind));
  }
}

}  // namespace

JobIdentity identity_of_this_program(std::string kind, std::string data, std::string spec) {
  return {std::move(kind), CASTAWAY_VERSION, program_hash(), std::move(data), std::move(spec)};
}

JobFolder::JobFolder(fs::path folder, const JobIdentity& identity) : folder_(std::move(folder)) {
  check_same_batch(folder_, identity);
  make_folder(folder_);
  // The marker comes first: whatever follows is the batch's.
  const std::string marker = marker_of(identity.kind);
  if (!fs::exists(folder_ / marker)) {
    write_own_file(folder_ / marker, json_text(identity_json(identity), 1) + "\n");
  }
  const std::string specification = specification_of(identity.kind);
  if (!fs::exists(folder_ / specification)) {
    write_own_file(folder_ / specification, identity.spec);
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
