#include "tools/scenario/campaign_yaml.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/base/process/seed_range.hpp"
#include "tools/scenario/base_scenario.hpp"
#include "tools/scenario/sections/expect_yaml.hpp"
#include "tools/scenario/sections/name_yaml.hpp"

namespace castaway::testbed {
namespace {

/// Keys of a scenario that a campaign sets itself.
const std::vector<std::string> kSetByCampaign{"seed", "name", "expect"};

void require_free(const std::string& path, const YamlReader& value) {
  const std::string head = path.substr(0, path.find('.'));
  const auto& own = kSetByCampaign;
  if (std::find(own.begin(), own.end(), head) == own.end()) return;
  value.fail(fmt::format("'{}' cannot vary: a campaign sets it itself", head));
}

std::vector<GridKey> read_grid(YamlReader& root) {
  std::vector<GridKey> grid;
  for (auto& [path, value] : root.child("grid").entries()) {
    require_free(path, value);
    GridKey key{path, {}, value.raw().where};
    if (!value.is_list()) value.fail("expected a list of values, e.g. [4, 8, 12]");
    for (const YamlReader& item : value.items()) key.values.push_back(item.raw());
    if (key.values.empty()) value.fail("has no value; give at least one");
    grid.push_back(std::move(key));
  }
  return grid;
}

std::vector<DrawnKey> read_drawn(YamlReader& root) {
  std::vector<DrawnKey> drawn;
  for (auto& [path, value] : root.child("draw").entries()) {
    require_free(path, value);
    const std::string where = value.raw().where;
    drawn.push_back({path, read_draw(value), where});
  }
  return drawn;
}

KeepOfCell read_keep(YamlReader& root) {
  const std::map<std::string, KeepOfCell> kinds{{"summary", KeepOfCell::kSummary},
                                                {"errors", KeepOfCell::kErrors},
                                                {"folder", KeepOfCell::kFolder},
                                                {"failures", KeepOfCell::kFailures}};
  return kinds.at(root.choice("keep", "summary", {"summary", "errors", "folder", "failures"}));
}

SeedRange read_seeds(YamlReader& root) {
  const auto value = root.find("seeds");
  if (!value) return {};
  try {
    return parse_seeds(value->as<std::string>(), 1);
  } catch (const std::invalid_argument& error) {
    value->fail(error.what());
  }
}

/// Reads seeds and design; the keys have been drawn from the file already.
void read_samples(YamlReader& root, CampaignSpec& spec) {
  const SeedRange seeds = read_seeds(root);
  spec.first_seed = seeds.first;
  const std::string name = root.choice("design", kDesignNames.front(), kDesignNames);
  const auto found = std::find(kDesignNames.begin(), kDesignNames.end(), name);
  const auto design = static_cast<Design>(found - kDesignNames.begin());
  if (design != Design::kIndependent && spec.drawn.empty()) {
    root.find("design")->fail("needs keys under 'draw'");
  }
  std::vector<std::string> keys;
  for (const DrawnKey& key : spec.drawn) keys.push_back(key.path);
  spec.design = SampleDesign(design, spec.seed, seeds.count, keys);
}

std::optional<UntilSpec> read_until(YamlReader& root, const SampleDesign& design) {
  if (!root.has("until")) return std::nullopt;
  YamlReader map = root.child("until");
  UntilSpec until;
  until.metric = map.require<std::string>("metric");
  until.width = map.require<double>("width");
  map.find("width")->require_in({1e-12, 1e12}, "");
  until.first = map.get("first", until.first);
  if (until.first < 2) map.fail("'first' must be at least 2");
  const bool grows = design.design() == Design::kIndependent || design.design() == Design::kSobol;
  if (!grows) map.fail("needs the design independent or sobol: the others have a fixed size");
  return until;
}

/// Report, player and pictures are made where they are asked for.
void adapt(YamlNode& scenario) {
  for (const std::string& key : kSetByCampaign) drop_key(scenario, key);
  const YamlNode* outputs = scenario.find("outputs");
  for (const char* unless_asked : {"report", "player", "snapshots"}) {
    if (outputs != nullptr && outputs->find(unless_asked) != nullptr) continue;
    put_value(scenario, std::string("outputs.") + unless_asked, write_yaml(false), "");
  }
}

void require_possible(const CampaignSpec& spec) {
  double cells = spec.samples();
  for (const GridKey& key : spec.grid) cells *= static_cast<double>(key.values.size());
  if (cells <= kMostCells) return;
  throw std::invalid_argument(
      fmt::format("{}: {:.0f} cells, and {} are possible: leave out values "
                  "or seeds",
                  spec.file, cells, kMostCells));
}

std::string effective_text(YamlReader& root, const CampaignSpec& spec) {
  YamlNode tree = root.raw();
  put_value(tree, "seed", write_yaml(spec.seed), "");
  put_value(tree, "scenario", spec.scenario, "");
  return emit_yaml(tree);
}

}  // namespace

int CampaignSpec::combinations() const {
  std::size_t count = 1;
  for (const GridKey& key : grid) count *= key.values.size();
  return static_cast<int>(count);
}

CampaignSpec load_campaign_spec(const std::filesystem::path& file, FilePrograms programs,
                                const std::vector<std::string>& overrides) {
  YamlDocument document = YamlDocument::load(file);
  YamlReader root = document.root();
  CampaignSpec spec;
  spec.file = file.string();
  spec.programs = programs;
  spec.name = get_name(root, "name", file.stem().string());
  spec.seed = root.get("seed", spec.seed);
  BaseScenario base = read_base_scenario(root, file.parent_path());
  spec.scenario = std::move(base.scenario);
  spec.base = std::move(base.folder);
  spec.grid = read_grid(root);
  spec.drawn = read_drawn(root);
  read_samples(root, spec);
  spec.until = read_until(root, spec.design);
  spec.keep = read_keep(root);
  spec.timeout_s = root.get("timeout_s", spec.timeout_s);
  if (const auto limit = root.find("timeout_s")) {
    limit->require_in({0.0, 1e7}, "s");
  }
  spec.expect = root.child("expect").raw();
  document.reject_unknown_keys();
  for (const std::string& assignment : overrides) apply_override(spec.scenario, assignment);
  require_possible(spec);
  spec.effective = effective_text(root, spec);
  adapt(spec.scenario);
  return spec;
}

std::vector<Expectation> expectations_of(const CampaignSpec& spec,
                                         const std::vector<std::string>& localizers) {
  YamlNode tree;
  tree.kind = YamlNode::Kind::kMap;
  tree.entries.push_back({"expect", spec.expect});
  YamlReader root(tree, "");
  return read_expectations(root, localizers);
}

}  // namespace castaway::testbed
