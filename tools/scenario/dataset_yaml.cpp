#include "tools/scenario/dataset_yaml.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/scenario/base_scenario.hpp"
#include "tools/scenario/sections/name_yaml.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Keys of a scenario that a data set sets itself.
const std::vector<std::string> kOwn{"seed", "name", "outputs", "expect"};

/// Adapts a scenario to a data set: removes its own keys, and sets localizers and outputs.
void adapt_scenario(YamlNode& scenario, const YamlNode& outputs) {
  for (const std::string& key : kOwn) drop_key(scenario, key);
  if (scenario.find("localizers") == nullptr) {
    put_value(scenario, "localizers", parse_yaml("[]", ""), "");
  }
  put_value(scenario, "outputs", outputs, outputs.where);
  for (const char* unless_asked : {"report", "player", "snapshots"}) {
    const std::string path = std::string("outputs.") + unless_asked;
    if (outputs.find(unless_asked) == nullptr) put_value(scenario, path, write_yaml(false), "");
  }
}

YamlNode read_dataset_outputs(YamlReader& root) {
  const auto outputs = root.find("outputs");
  if (!outputs) return parse_yaml("{bag: true, tables: hdf5}", "outputs");
  if (!outputs->is_map()) outputs->fail("expected a map, e.g. {bag: true, tables: hdf5}");
  return outputs->raw();
}

std::vector<VariedKey> read_vary(YamlReader& root) {
  std::vector<VariedKey> vary;
  for (auto& [path, value] : root.child("vary").entries()) {
    const std::string head = path.substr(0, path.find('.'));
    if (std::find(kOwn.begin(), kOwn.end(), head) != kOwn.end()) {
      value.fail(fmt::format("'{}' cannot vary: a data set sets it itself", head));
    }
    const std::string where = value.raw().where;
    vary.push_back({path, read_draw(value), where});
  }
  return vary;
}

SplitSpec read_splits(YamlReader& root) {
  SplitSpec splits;
  YamlReader map = root.child("splits");
  splits.train = map.get("train", splits.train);
  splits.val = map.get("val", splits.val);
  splits.test = map.get("test", splits.test);
  splits.by_sequence = map.choice("by", "world", {"world", "sequence"}) == "sequence";
  if (std::min({splits.train, splits.val, splits.test}) < 0.0 ||
      !(splits.train + splits.val + splits.test > 0.0)) {
    map.fail("'train', 'val' and 'test' are shares: none negative, not all 0");
  }
  return splits;
}

/// YAML of the specification with the base scenario included.
std::string effective_text(YamlReader& root, const DatasetSpec& spec, const YamlNode& outputs) {
  YamlNode tree = root.raw();
  YamlNode scenario = spec.scenario;
  drop_key(scenario, "outputs");
  put_value(tree, "seed", write_yaml(spec.seed), "");
  put_value(tree, "scenario", scenario, "");
  put_value(tree, "outputs", outputs, "");
  return emit_yaml(tree);
}

}  // namespace

DatasetSpec load_dataset_spec(const fs::path& file, const DatasetOverrides& overrides) {
  YamlDocument document = YamlDocument::load(file);
  YamlReader root = document.root();
  DatasetSpec spec;
  spec.file = file.string();
  spec.programs = overrides.programs;
  spec.name = get_name(root, "name", file.stem().string());
  spec.description = root.get("description", "");
  spec.license = root.get("license", "");
  spec.seed = root.get("seed", spec.seed);
  if (overrides.seed) spec.seed = *overrides.seed;
  BaseScenario base = read_base_scenario(root, file.parent_path());
  spec.scenario = std::move(base.scenario);
  spec.base = std::move(base.folder);
  const YamlNode outputs = read_dataset_outputs(root);
  spec.vary = read_vary(root);
  spec.splits = read_splits(root);
  document.reject_unknown_keys();
  for (const std::string& assignment : overrides.scenario) {
    apply_override(spec.scenario, assignment);
  }
  adapt_scenario(spec.scenario, outputs);
  spec.effective = effective_text(root, spec, outputs);
  return spec;
}

}  // namespace castaway::testbed
