#include "tools/campaign_page/campaign_pages.hpp"

#include <exception>

#include "tools/campaign_page/campaign_page.hpp"
#include "tools/campaign_page/cost_page.hpp"
#include "tools/cells/campaign_cell.hpp"
#include "tools/sources/build_simulation.hpp"

namespace castaway::testbed {
namespace {

/// The map that the localizers of a cell have; nothing if the cell cannot be built, which its row
/// says.
std::optional<RosMap> map_of_cell(const CampaignSpec& spec, int cell) {
  try {
    return build_simulation(campaign_cell(spec, cell).loaded.scenario, spec.base).map;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

CampaignPages render_campaign_pages(const FinishedCampaign& campaign) {
  const CampaignFigures figures = gather_figures(campaign);
  return {{"campaign.html", render_campaign_page(campaign, figures, map_of_cell)},
          {"costs.html", render_cost_page(campaign, figures.figures.axes())}};
}

}  // namespace castaway::testbed
