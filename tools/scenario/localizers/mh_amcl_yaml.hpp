/// Settings of MH-AMCL as YAML.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "localization/mh_amcl/mh_amcl_config.hpp"
#include "localization/paper/published/published_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// `improved`, `3d` (the same on a 3-D map), `paper`, `published` (the paper's method with all
/// defects of the published code).
const std::vector<std::string>& mh_amcl_modes();

using MhAmclSettings =
    std::variant<localization::MhAmclConfig, localization::MhAmcl3dConfig,
                 localization::PaperMhAmclConfig, localization::PublishedMhAmclConfig>;

MhAmclSettings mh_amcl_mode(const std::string& mode);

/// Default name of a localizer of a mode.
std::string mh_amcl_name(const std::string& mode);

/// Reads the settings of a localizer; missing ones are those of the mode. `defects` lists switches
/// of `PublishedDefects` by name, in modes `paper` and `published` only.
MhAmclSettings read_mh_amcl(YamlReader& body, const std::string& mode);

}  // namespace castaway::testbed
