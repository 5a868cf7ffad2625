/// The stages of the MH-AMCL that its authors published: the paper's, with what their code does
/// otherwise.
#pragma once

#include "localization/paper/paper_stages.hpp"
#include "localization/paper/published/published_config.hpp"

namespace castaway::localization {

/// The paper's stages with those in place of which a defect that is on puts another. Throws
/// std::invalid_argument for a map or settings that make no sense.
PaperStages published_stages(const PublishedMhAmclConfig& config, const OccupancyGrid& map);

}  // namespace castaway::localization
