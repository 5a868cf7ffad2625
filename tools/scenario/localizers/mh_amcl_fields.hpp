/// Settings of the MH-AMCLs by their YAML keys.
#pragma once

#include "localization/mh_amcl/mh_amcl_config.hpp"
#include "localization/paper/published/published_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

void fields(Settings settings, localization::MhAmclConfig& config);

/// Settings that only `mh_amcl: {mode: 3d}` has.
void map3d_fields(Settings settings, localization::MhAmcl3dConfig& config);
/// All of its settings.
void fields(Settings settings, localization::MhAmcl3dConfig& config);

/// Settings of `mh_amcl: {mode: paper}`.
void fields(Settings settings, localization::PaperMhAmclConfig& config);

/// Additional settings of the published code; `read_mh_amcl` reads its `defects`.
void fields(Settings settings, localization::PublishedMhAmclConfig& config);

}  // namespace castaway::testbed
