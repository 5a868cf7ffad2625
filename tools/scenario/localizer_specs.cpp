// Localizers as YAML and as words of a command line.
#include <algorithm>
#include <stdexcept>

#include "tools/scenario/amcl_spec.hpp"
#include "tools/scenario/nearest.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

using localization::MhAmclConfig;

const std::vector<std::string> kKinds = {"mh_amcl", "amcl"};
const std::vector<std::string> kMhAmclModes = {"improved", "paper"};
const char* const kToldPreset = "amcl-global";

MhAmclConfig mh_amcl_mode(const std::string& mode) {
  MhAmclConfig config;
  if (mode == "paper") config.mode = localization::MhAmclMode::kPaper;
  return config;
}

MhAmclConfig read_mh_amcl(YamlReader& body, const std::string& mode) {
  MhAmclConfig config = mh_amcl_mode(mode);
  config.predict_rate_hz = body.get("predict_rate_hz", config.predict_rate_hz);
  config.correct_rate_hz = body.get("correct_rate_hz", config.correct_rate_hz);
  config.reseed_rate_hz = body.get("reseed_rate_hz", config.reseed_rate_hz);
  config.beams.max_beams = body.get("max_beams", config.beams.max_beams);
  config.beams.max_range = body.get("max_range", config.beams.max_range);
  config.reseed.min_particles = body.get("min_particles", config.reseed.min_particles);
  config.reseed.max_particles = body.get("max_particles", config.reseed.max_particles);
  config.motion.trans_per_m = body.get("trans_per_m", config.motion.trans_per_m);
  config.motion.trans_per_rad = body.get("trans_per_rad", config.motion.trans_per_rad);
  config.motion.rot_per_m = body.get("rot_per_m", config.motion.rot_per_m);
  config.motion.rot_per_rad = body.get("rot_per_rad", config.motion.rot_per_rad);
  config.match.confident = body.get("confident", config.match.confident);
  config.select_margin = body.get("select_margin", config.select_margin);
  try {
    validate(config);
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
  return config;
}

LocalizerSpec read_localizer(YamlReader item) {
  auto [kind, body] = item.named();
  LocalizerSpec spec;
  if (kind == "mh_amcl") {
    const std::string mode = body.choice("mode", "improved", kMhAmclModes);
    spec.config = read_mh_amcl(body, mode);
    spec.name = mode == "improved" ? kind : kind + "-" + mode;
  } else if (kind == "amcl") {
    spec.name = body.choice("preset", "amcl", amcl_presets());
    spec.config = read_amcl(body, spec.name);
    spec.relocalize_at_kidnap = spec.name == kToldPreset;
  } else {
    item.fail("unknown localizer '" + kind + "'; " + suggestion(kind, kKinds));
  }
  spec.relocalize_at_kidnap = body.get("global_localization_at_kidnap", spec.relocalize_at_kidnap);
  spec.name = body.get("name", spec.name);
  return spec;
}

}  // namespace

std::vector<LocalizerSpec> read_localizers(YamlReader& root, const std::string& key) {
  std::vector<LocalizerSpec> specs;
  for (YamlReader item : root.list(key)) {
    specs.push_back(read_localizer(item));
    const auto same = std::count_if(specs.begin(), specs.end(), [&](const LocalizerSpec& other) {
      return other.name == specs.back().name;
    });
    if (same > 1) item.fail("two localizers are called '" + specs.back().name + "'; give a 'name'");
  }
  if (specs.empty()) root.fail("'" + key + "' is empty: name at least one, e.g. [mh_amcl, amcl]");
  return specs;
}

LocalizerSpec parse_localizer(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string preset = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "mh_amcl") {
    const std::string mode = preset.empty() ? "improved" : preset;
    if (std::find(kMhAmclModes.begin(), kMhAmclModes.end(), mode) == kMhAmclModes.end()) {
      throw std::invalid_argument("unknown mode '" + preset + "' of mh_amcl; " +
                                  suggestion(preset, kMhAmclModes));
    }
    return {mode == "improved" ? kind : kind + "-" + mode, mh_amcl_mode(mode)};
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
  throw std::invalid_argument("unknown localizer '" + text + "'; " + suggestion(kind, kKinds));
}

}  // namespace castaway::testbed
