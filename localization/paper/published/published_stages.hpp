/// The stages of the authors' published MH-AMCL: the paper's stages with the published code's
/// differences.
#pragma once

#include "localization/paper/paper_stages.hpp"
#include "localization/paper/published/published_config.hpp"
#include "localization/paper/published/published_defects.hpp"

namespace castaway::localization {

/// A cascade with `wide_headings`, `one_coarse_level` and `transposed_search`.
PaperCascade published_cascade(PaperCascadeConfig config, const RayLocalConfig& sensor,
                               const OccupancyGrid& grid, const PublishedDefects& defects);

/// True if the published code searches a cell: its limits of x and y are swapped, so that only
/// cells below both limits in map are searched.
bool is_in_transposed_search(const GridFrame& frame, int column, int row);

/// The scan as if the lidar were at base (`mount_ignored`).
ScanPoints points_at_base(const MatchScan& scan, const BeamSelection& beams);

/// Returns the paper's stages, with those replaced that a switched-on defect changes.
/// @throws std::invalid_argument for an invalid map or settings.
PaperStages published_stages(const PublishedMhAmclConfig& config, const OccupancyGrid& map);

}  // namespace castaway::localization
