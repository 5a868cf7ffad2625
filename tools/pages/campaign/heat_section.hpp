/// Kidnap targets on the map.
#pragma once

#include <optional>
#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/pages/campaign/figures/campaign_figures.hpp"

namespace castaway::testbed {

/// The map of a world; nothing if it has none.
using MapOfWorld = std::optional<RosMap> (*)(const CampaignSpec& spec, int cell);

/// A world's bins on its map, as SVG with a layer for each localizer; the first one is shown.
std::string heat_svg(const CampaignFigures& figures, const std::string& world,
                     const std::optional<RosMap>& map);

/// The maps of all worlds with their legends and the table of the bins, as HTML.
std::string heat_section(const FinishedCampaign& campaign, const CampaignFigures& figures,
                         MapOfWorld map_of_world);

}  // namespace castaway::testbed
