#include "tools/scenario/localizers/localizer_specs.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/scenario/localizers/amcl_yaml.hpp"
#include "tools/scenario/localizers/mh_amcl_fields.hpp"
#include "tools/scenario/localizers/mh_amcl_yaml.hpp"
#include "tools/scenario/localizers/ros2_yaml.hpp"
#include "tools/scenario/sections/name_yaml.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

const std::vector<std::string> kLocalizerKinds = {"mh_amcl", "amcl", "program", "library", "ros2"};
const char* const kToldPreset = "amcl-global";

LocalizerSpec read_localizer(YamlReader item, const ForeignRules& rules) {
  if (auto foreign = read_foreign(item, rules)) return *foreign;
  if (auto node = read_ros2(item, rules)) return *node;
  auto [kind, body] = item.name_and_body();
  LocalizerSpec spec;
  if (kind == "mh_amcl") {
    const std::string mode = body.choice("mode", "improved", mh_amcl_modes());
    std::visit([&](const auto& config) { spec.config = config; }, read_mh_amcl(body, mode));
    spec.name = mh_amcl_name(mode);
  } else if (kind == "amcl") {
    spec.name = body.choice("preset", "amcl", amcl_presets());
    spec.config = read_amcl(body, spec.name);
    spec.relocalize_at_kidnap = spec.name == kToldPreset;
  } else if (kind == "python" || kind == "own") {
    spec.name = kind;
    spec.config = OwnConfig{};
  } else {
    item.fail("unknown localizer '" + kind + "'; " + suggestion(kind, kLocalizerKinds));
  }
  spec.relocalize_at_kidnap = body.get("global_localization_at_kidnap", spec.relocalize_at_kidnap);
  spec.name = get_name(body, "name", spec.name);
  return spec;
}

std::vector<LocalizerSpec> load_localizers(const std::string& file, FilePrograms programs) {
  YamlDocument document = YamlDocument::load(file);
  YamlReader root = document.root();
  std::vector<LocalizerSpec> specs =
      read_localizers(root, "localizers", {std::filesystem::path(file).parent_path(), programs});
  document.reject_unknown_keys();
  if (specs.empty()) throw std::runtime_error(file + ": lists no localizer; name at least one");
  return specs;
}

}  // namespace

bool names_a_file(const std::string& text) {
  const bool is_foreign = text.starts_with("program:") || text.starts_with("library:");
  return !is_foreign && (text.ends_with(".yaml") || text.ends_with(".yml"));
}

std::vector<LocalizerSpec> read_localizers(YamlReader& root, const std::string& key,
                                           const ForeignRules& rules) {
  std::vector<LocalizerSpec> specs;
  for (const YamlReader& item : root.list(key)) {
    specs.push_back(read_localizer(item, rules));
    if (specs.back().name == "truth") {
      item.fail("a localizer cannot be called 'truth': truth.tum is taken");
    }
    const auto same = std::count_if(specs.begin(), specs.end(), [&](const LocalizerSpec& other) {
      return other.name == specs.back().name;
    });
    if (same > 1) item.fail("two localizers are called '" + specs.back().name + "'; give a 'name'");
  }
  return specs;
}

void describe_localizers(std::vector<SettingText>& texts) {
  const auto under = [&](const std::string& kind) {
    Settings settings = Settings::describing(texts, "localizers[]." + kind + ".");
    settings.form({"name", "", "Names its files."}, "the kind's");
    settings.form({"global_localization_at_kidnap", "",
                   "The localizer is notified of kidnaps and relocalizes globally."},
                  "false");
    return settings;
  };
  Settings improved = under("mh_amcl");
  improved.form({"mode", "", "improved, 3d, paper, published."}, "improved");
  localization::MhAmclConfig mh_amcl;
  fields(improved, mh_amcl);
  localization::MhAmcl3dConfig on_3d_map;
  map3d_fields(under("mh_amcl (mode 3d, besides those above)"), on_3d_map);
  localization::PublishedMhAmclConfig paper;
  fields(under("mh_amcl (modes paper and published)"), paper);
  Settings nav2 = under("amcl");
  nav2.form({"preset", "", "amcl, amcl-recovery, amcl-global, amcl-prob."}, "amcl");
  localization::AmclConfig amcl;
  fields(nav2, amcl);
  describe_foreign(texts);
  describe_ros2(texts);
}

LocalizerSpec parse_localizer(const std::string& text) {
  if (auto foreign = parse_foreign(text)) return *foreign;
  if (auto node = parse_ros2(text)) return *node;
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string preset = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "mh_amcl") {
    const std::string mode = preset.empty() ? "improved" : preset;
    const std::vector<std::string>& modes = mh_amcl_modes();
    if (std::find(modes.begin(), modes.end(), mode) == modes.end()) {
      throw std::invalid_argument("unknown mode '" + preset + "' of mh_amcl; " +
                                  suggestion(preset, mh_amcl_modes()));
    }
    LocalizerSpec spec{mh_amcl_name(mode), {}};
    std::visit([&](const auto& config) { spec.config = config; }, mh_amcl_mode(mode));
    return spec;
  }
  const std::string chosen = preset.empty() ? "amcl" : preset;
  if (kind == "amcl") {
    const std::vector<std::string>& presets = amcl_presets();
    if (std::find(presets.begin(), presets.end(), chosen) != presets.end()) {
      return {chosen, amcl_preset(chosen), chosen == kToldPreset};
    }
    throw std::invalid_argument("unknown preset '" + preset + "' of amcl; " +
                                suggestion(preset, amcl_presets()));
  }
  throw std::invalid_argument("unknown localizer '" + text + "'; " +
                              suggestion(kind, kLocalizerKinds));
}

std::string localizer_yaml(const std::string& text) {
  const LocalizerSpec spec = parse_localizer(text);  // Throws if there is no such localizer.
  if (is_foreign(spec)) return foreign_yaml(spec);
  if (is_node(spec)) return ros2_yaml(text);
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return text;
  const std::string kind = text.substr(0, colon);
  return fmt::format("{{{}: {{{}: {}}}}}", kind, kind == "amcl" ? "preset" : "mode",
                     text.substr(colon + 1));
}

bool is_on_map3d(const LocalizerSpec& spec) {
  return std::holds_alternative<localization::MhAmcl3dConfig>(spec.config);
}

std::vector<LocalizerSpec> parse_localizers(const std::vector<std::string>& texts,
                                            FilePrograms programs) {
  std::vector<LocalizerSpec> specs;
  for (const std::string& text : texts) {
    const auto more = names_a_file(text) ? load_localizers(text, programs)
                                         : std::vector<LocalizerSpec>{parse_localizer(text)};
    specs.insert(specs.end(), more.begin(), more.end());
  }
  std::set<std::string> names;
  for (const LocalizerSpec& spec : specs) {
    if (names.insert(spec.name).second) continue;
    throw std::invalid_argument("two localizers are called '" + spec.name + "'");
  }
  return specs;
}

}  // namespace castaway::testbed
