#include "tools/scenario/sections/mh_amcl_spec.hpp"

#include <stdexcept>

#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

using localization::MhAmclConfig;
using localization::NamedDefect;
using localization::PaperMhAmclConfig;
using localization::PublishedDefects;
using localization::PublishedMhAmclConfig;

/// The defects of a list.
PublishedDefects read_defects(const YamlReader& list) {
  std::vector<std::string> known;
  for (const NamedDefect& defect : localization::named_defects()) known.emplace_back(defect.name);
  PublishedDefects defects;
  for (const YamlReader& item : list.items()) {
    const auto name = item.as<std::string>();
    bool found = false;
    for (const NamedDefect& defect : localization::named_defects()) {
      if (defect.name == name) found = defects.*defect.on = true;
    }
    if (!found) item.fail("unknown defect '" + name + "'; " + suggestion(name, known));
  }
  return defects;
}

/// The settings that all modes have keys for.
MhAmclConfig read_common(YamlReader& body) {
  MhAmclConfig config;
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
  config.lost_and_found.found = body.get("found", config.lost_and_found.found);
  config.select_margin = body.get("select_margin", config.select_margin);
  return config;
}

/// The paper's part of what was read.
PaperMhAmclConfig with_common(PaperMhAmclConfig paper, const MhAmclConfig& common) {
  paper.predict_rate_hz = common.predict_rate_hz;
  paper.correct_rate_hz = common.correct_rate_hz;
  paper.reseed_rate_hz = common.reseed_rate_hz;
  paper.beams = common.beams;
  paper.motion = common.motion;
  paper.size = common.reseed;
  return paper;
}

}  // namespace

const std::vector<std::string>& mh_amcl_modes() {
  static const std::vector<std::string> modes = {"improved", "paper", "published"};
  return modes;
}

MhAmclSettings mh_amcl_mode(const std::string& mode) {
  if (mode == "published") return localization::published_config();
  if (mode == "paper") return PaperMhAmclConfig{};
  return MhAmclConfig{};
}

std::string mh_amcl_name(const std::string& mode) {
  return mode == "improved" ? "mh_amcl" : "mh_amcl-" + mode;
}

MhAmclSettings read_mh_amcl(YamlReader& body, const std::string& mode) {
  const MhAmclConfig common = read_common(body);
  const auto defects = mode == "improved" ? std::nullopt : body.find("defects");
  PublishedMhAmclConfig published;
  if (mode == "published") published = localization::published_config();
  if (defects) published.defects = read_defects(*defects);
  published.paper = with_common(published.paper, common);
  try {
    validate(common);
    validate(published.paper);
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
  if (mode == "improved") return common;
  if (mode == "published" || defects) return published;
  return published.paper;
}

}  // namespace castaway::testbed
