#include "tools/scenario/localizers/mh_amcl_yaml.hpp"

#include <stdexcept>

#include "tools/scenario/localizers/mh_amcl_fields.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

using localization::MhAmcl3dConfig;
using localization::MhAmclConfig;
using localization::NamedDefect;
using localization::PaperMhAmclConfig;
using localization::PublishedDefects;
using localization::PublishedMhAmclConfig;

/// Reads a list of defect names.
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

/// Reads a map by its settings table.
template <typename Config>
Config read(YamlReader& body, Config config) {
  fields(Settings::reading(body), config);
  return config;
}

}  // namespace

const std::vector<std::string>& mh_amcl_modes() {
  static const std::vector<std::string> modes = {"improved", "3d", "paper", "published"};
  return modes;
}

MhAmclSettings mh_amcl_mode(const std::string& mode) {
  if (mode == "published") return localization::published_config();
  if (mode == "paper") return PaperMhAmclConfig{};
  if (mode == "3d") return MhAmcl3dConfig{};
  return MhAmclConfig{};
}

std::string mh_amcl_name(const std::string& mode) {
  return mode == "improved" ? "mh_amcl" : "mh_amcl-" + mode;
}

MhAmclSettings read_mh_amcl(YamlReader& body, const std::string& mode) {
  try {
    if (mode == "improved") {
      const MhAmclConfig config = read(body, MhAmclConfig{});
      validate(config);
      return config;
    }
    if (mode == "3d") {
      const MhAmcl3dConfig config = read(body, MhAmcl3dConfig{});
      validate(config.mh_amcl);
      return config;
    }
    const bool published = mode == "published";
    const auto config =
        read(body, published ? localization::published_config() : PublishedMhAmclConfig{});
    validate(config.paper);
    const auto list = body.find("defects");
    if (!list && !published) return config.paper;
    PublishedMhAmclConfig result = config;
    if (list) result.defects = read_defects(*list);
    return result;
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
}

}  // namespace castaway::testbed
