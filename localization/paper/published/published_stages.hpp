/// The stages of the authors' published MH-AMCL: the paper's stages with the published code's
/// differences.
#pragma once

#include "localization/paper/paper_stages.hpp"
#include "localization/paper/published/published_config.hpp"

namespace castaway::localization {

/// Returns the paper's stages, with those replaced that a switched-on defect changes.
/// @throws std::invalid_argument for an invalid map or settings.
PaperStages published_stages(const PublishedMhAmclConfig& config, const OccupancyGrid& map);

}  // namespace castaway::localization
