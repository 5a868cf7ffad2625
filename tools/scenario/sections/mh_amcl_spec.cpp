#include "tools/scenario/sections/mh_amcl_spec.hpp"

#include <stdexcept>

#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

using localization::MhAmclConfig;
using localization::NamedDefect;
using localization::PublishedDefects;

/// The defects that are listed; those of the mode where there is no list.
PublishedDefects read_defects(YamlReader& body, const PublishedDefects& usual) {
  const auto list = body.find("defects");
  if (!list) return usual;
  std::vector<std::string> known;
  for (const NamedDefect& defect : localization::named_defects()) known.emplace_back(defect.name);
  PublishedDefects defects;
  for (const YamlReader& item : list->items()) {
    const auto name = item.as<std::string>();
    bool found = false;
    for (const NamedDefect& defect : localization::named_defects()) {
      if (defect.name == name) found = defects.*defect.on = true;
    }
    if (!found) item.fail("unknown defect '" + name + "'; " + suggestion(name, known));
  }
  return defects;
}

}  // namespace

const std::vector<std::string>& mh_amcl_modes() {
  static const std::vector<std::string> modes = {"improved", "paper", "published"};
  return modes;
}

MhAmclConfig mh_amcl_mode(const std::string& mode) {
  if (mode == "published") return localization::published_config();
  MhAmclConfig config;
  if (mode == "paper") config.mode = localization::MhAmclMode::kPaper;
  return config;
}

std::string mh_amcl_name(const std::string& mode) {
  return mode == "improved" ? "mh_amcl" : "mh_amcl-" + mode;
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
  config.found = body.get("found", config.found);
  config.select_margin = body.get("select_margin", config.select_margin);
  if (mode != "improved") config.paper.published = read_defects(body, config.paper.published);
  try {
    validate(config);
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
  return config;
}

}  // namespace castaway::testbed
