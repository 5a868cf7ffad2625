/// The settings of the MH-AMCLs, by their keys in YAML.
#pragma once

#include "localization/mh_amcl_config.hpp"
#include "localization/paper/published/published_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// All settings of `mh_amcl`.
void fields(Settings settings, localization::MhAmclConfig& config);

/// All settings of `mh_amcl: {mode: paper}`.
void fields(Settings settings, localization::PaperMhAmclConfig& config);

/// What the published code knows besides; its `defects` are read by `read_mh_amcl`.
void fields(Settings settings, localization::PublishedMhAmclConfig& config);

}  // namespace castaway::testbed
