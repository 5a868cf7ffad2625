#include "tools/batch/campaign/campaign_folder.hpp"

#include <stdexcept>

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

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kMarker = "campaign.json";
constexpr const char* kSpecification = "campaign.yaml";

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
  for (const char* name : {kMarker, kSpecification}) require_no_link(folder, name);
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
    const fs::path file = folder / kSpecification;
    if (fs::exists(file, none) && read_file(file) != identity.spec) {
      throw std::runtime_error(
          file.string() + ": was changed since castaway wrote it; remove it, and it is made anew");
    }
    return;
  }
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (!is_bookkeeping(name))
      refuse_folder(folder, fmt::format("holds '{}' and no campaign", name));
  }
}

}  // namespace

CampaignFolder::CampaignFolder(fs::path folder, const CampaignIdentity& identity)
    : folder_(std::move(folder)) {
  check_same_campaign(folder_, identity);
  make_folder(folder_);
  // The marker comes first: whatever follows is the campaign's.
  if (!fs::exists(folder_ / kMarker)) {
    write_own_file(folder_ / kMarker, json_text(identity_json(identity), 1) + "\n");
  }
  if (!fs::exists(folder_ / kSpecification)) {
    write_own_file(folder_ / kSpecification, identity.spec);
  }
}

CampaignFolder::CampaignFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code none;
  if (fs::exists(folder_ / kMarker, none)) return;
  throw std::runtime_error(folder_.string() + ": is no folder of a campaign: has no campaign.json");
}

void CampaignFolder::put(const std::string& name,
                         const std::function<void(const fs::path& draft)>& write) const {
  put_own_file(folder_ / name, write);
}

}  // namespace castaway::testbed
