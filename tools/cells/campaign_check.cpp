#include "tools/cells/campaign_check.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "tools/cells/campaign_cell.hpp"
#include "tools/files/file.hpp"
#include "tools/files/sha256.hpp"
#include "tools/play/play.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// A file that a cell reads, and the image if it is a ROS map.
std::vector<fs::path> with_image(const fs::path& file) {
  std::vector<fs::path> files{file};
  if (file.extension() != ".yaml") return files;
  const YamlNode root = parse_yaml(read_file(file), file.string());
  const YamlNode* image = root.find("image");
  if (image != nullptr) files.push_back(file.parent_path() / image->scalar);
  return files;
}

void add_localizers(const Scenario& scenario, std::vector<std::string>& names) {
  for (const std::string& name : names_of(scenario.localizers)) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
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
  return checked;
}

}  // namespace castaway::testbed
