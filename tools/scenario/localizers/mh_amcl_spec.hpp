/// Settings of MH-AMCL as YAML.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "localization/mh_amcl_config.hpp"
#include "localization/paper/published/published_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// `improved`, `paper`, `published` (the paper with all defects of the published code).
const std::vector<std::string>& mh_amcl_modes();

/// The settings of one of the MH-AMCLs.
using MhAmclSettings = std::variant<localization::MhAmclConfig, localization::PaperMhAmclConfig,
                                    localization::PublishedMhAmclConfig>;

/// The settings of a mode.
MhAmclSettings mh_amcl_mode(const std::string& mode);

/// What a localizer of a mode is called unless it is given a name.
std::string mh_amcl_name(const std::string& mode);

/// Reads a localizer's body; what it does not say is as in the mode. `defects` lists switches of
/// `PublishedDefects` by name, in modes `paper` and `published` only.
MhAmclSettings read_mh_amcl(YamlReader& body, const std::string& mode);

}  // namespace castaway::testbed
