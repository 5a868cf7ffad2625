#include "tools/batch/campaign/campaign_check.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/campaign_rank.hpp"
#include "tools/play/play.hpp"
#include "tools/scenario/sections/expect_yaml.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// A file that a cell reads, and the image if it is a ROS map.
std::vector<fs::path> with_image(const fs::path& file) {
  std::vector<fs::path> files{file};
  if (file.extension() != ".yaml") return files;
  const YamlNode root = parse_yaml(read_file(file, kLargestSettings), file.string());
  const YamlNode* image = root.find("image");
  if (image != nullptr) files.push_back(file.parent_path() / image->scalar);
  return files;
}

void add_localizers(const Scenario& scenario, std::vector<std::string>& names) {
  for (const std::string& name : names_of(scenario.localizers)) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

void check_until(const CheckedCampaign& checked) {
  if (!checked.spec.until) return;
  try {
    require_known_metric(checked.spec.until->metric, checked.localizers);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("{}: until: {}", checked.spec.file, error.what()));
  }
}

void check_ranking(const CampaignRequest& request, const CheckedCampaign& checked) {
  if (!request.rank) return;
  require_rankable(checked.spec);
  for (const std::string& metric : request.metrics) {
    require_known_metric(metric, checked.localizers);
  }
}

}  // namespace

CheckedCampaign check_campaign(const CampaignRequest& request) {
  CheckedCampaign checked;
  checked.spec = load_campaign_spec(request.spec, request.programs, request.overrides);
  std::map<fs::path, std::string> inputs;
  for (int k = 0; k < checked.spec.combinations(); ++k) {
    const CampaignCell cell = campaign_cell(checked.spec, k * checked.spec.samples());
    add_localizers(cell.loaded.scenario, checked.localizers);
    for (const fs::path& input : inputs_of(cell.loaded.scenario, checked.spec.base / "none")) {
      if (!fs::is_regular_file(input) || inputs.contains(input)) continue;
      for (const fs::path& file : with_image(input)) {
        if (fs::is_regular_file(file)) inputs[file] = sha256_of_file(file);
      }
    }
  }
  std::string hashes;
  for (const auto& [file, hash] : inputs) hashes += hash + "\n";
  checked.data = sha256(hashes);
  static_cast<void>(expectations_of(checked.spec, checked.localizers));
  check_until(checked);
  check_ranking(request, checked);
  return checked;
}

JobIdentity identity_of(const CheckedCampaign& campaign) {
  return identity_of_this_program("campaign", campaign.data, campaign.spec.effective);
}

}  // namespace castaway::testbed
