#include "tools/pages/campaign/campaign_pages.hpp"

#include <exception>

#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/pages/campaign/campaign_page.hpp"
#include "tools/pages/campaign/cost_page.hpp"

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
