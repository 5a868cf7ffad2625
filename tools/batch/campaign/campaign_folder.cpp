#include "tools/batch/campaign/campaign_folder.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kMarker = "campaign.json";
constexpr const char* kTables = ".tables.json";  // Hashes of the tables, by name.

[[noreturn]] void refuse_folder(const fs::path& folder, const std::string& why) {
  throw std::runtime_error(
      fmt::format("{}: {}; choose another folder with --out", folder.string(), why));
}

Json identity_json(const CampaignIdentity& identity) {
  return {{"castaway", identity.version},
          {"kind", "campaign"},
          {"program", identity.program},
          {"data", identity.data},
          {"spec", sha256(identity.spec)}};
}

/// What differs between the campaign of a folder and another one.
std::string difference_of(const Json& there, const Json& here) {
  if (there.value("castaway", "") != here.at("castaway")) {
    return fmt::format("was made by castaway {}, this is {}", there.value("castaway", "?"),
                       here.at("castaway").get<std::string>());
  }
  if (there.value("program", "") != here.at("program")) return "was made by another build";
  if (there.value("spec", "") != here.at("spec")) {
    return "was made from another specification, its campaign.yaml";
  }
  return "was made with other worlds or robots: their files have changed since";
}

void check_same_campaign(const fs::path& folder, const CampaignIdentity& identity) {
  std::error_code none;
  for (const char* name : {kMarker, kTables, "campaign.yaml"}) require_no_link(folder, name);
  if (fs::exists(folder, none) && !fs::is_directory(folder, none)) {
    refuse_folder(folder, "is no folder");
  }
  if (fs::exists(folder / kMarker, none)) {
    const Json here = identity_json(identity);
    const Json there = read_json(folder / kMarker);
    if (!there.is_object() || there.value("kind", "") != "campaign") {
      refuse_folder(folder, "its campaign.json is not castaway's");
    }
    if (there != here) refuse_folder(folder, difference_of(there, here));
    return;
  }
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    refuse_folder(folder,
                  fmt::format("holds '{}' and no campaign", entry.path().filename().string()));
  }
}

Json table_hashes(const fs::path& folder) {
  std::error_code none;
  if (!fs::exists(folder / kTables, none)) return Json::object();
  Json hashes = read_json(folder / kTables);
  const auto is_text = [](const Json& hash) { return hash.is_string(); };
  if (hashes.is_object() && std::all_of(hashes.begin(), hashes.end(), is_text)) return hashes;
  throw std::runtime_error((folder / kTables).string() +
                           ": is not castaway's list of the campaign's tables; remove it");
}

}  // namespace

CampaignFolder::CampaignFolder(fs::path folder, const CampaignIdentity& identity)
    : folder_(std::move(folder)) {
  check_same_campaign(folder_, identity);
  make_folder(folder_);
  if (fs::exists(folder_ / kMarker)) return;
  // The marker comes first: whatever follows is the campaign's.
  write_file(folder_ / kMarker, json_text(identity_json(identity), 1) + "\n");
  write_file(folder_ / "campaign.yaml", identity.spec);
}

CampaignFolder::CampaignFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code none;
  if (fs::exists(folder_ / kMarker, none)) return;
  throw std::runtime_error(folder_.string() + ": is no folder of a campaign: has no campaign.json");
}

fs::path CampaignFolder::draft_of(const std::string& name) const {
  return folder_ / ("." + name + ".part");
}

void CampaignFolder::clear_draft(const std::string& name) const {
  std::error_code error;
  fs::remove(draft_of(name), error);
  if (error) {
    throw FileError(
        fmt::format("{}: cannot be removed ({})", draft_of(name).string(), error.message()));
  }
}

void CampaignFolder::commit(const std::string& name) const {
  const fs::path target = folder_ / name;
  Json hashes = table_hashes(folder_);
  if (fs::exists(target) && hashes.value(name, "") != sha256_of_file(target)) {
    fs::remove(draft_of(name));
    throw std::runtime_error(target.string() +
                             ": castaway did not write it, or it was changed since; move it away");
  }
  hashes[name] = sha256_of_file(draft_of(name));
  write_file(folder_ / kTables, json_text(hashes, 1) + "\n");
  fs::rename(draft_of(name), target);
}

}  // namespace castaway::testbed
