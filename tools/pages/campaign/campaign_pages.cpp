#include "tools/pages/campaign/campaign_pages.hpp"

#include <exception>

#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/pages/campaign/cost_page.hpp"
#include "tools/pages/campaign/figures_section.hpp"
#include "tools/pages/campaign/headline_section.hpp"
#include "tools/pages/campaign/pairs_section.hpp"
#include "tools/pages/campaign/specification_section.hpp"
#include "tools/pages/campaign/worst_section.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"

namespace castaway::testbed {
namespace {

/// Colours of the squares, on the light picture of the map in both themes.
constexpr const char* kHeatStyle = R"(
.specification td, .specification th { text-align: left; } h3 { font-size: 1rem; margin: 0.8rem 0 0.3rem; }
.heat polygon { fill-opacity: 0.85; stroke: #fff; stroke-width: 0.3; }
svg .heat text { text-anchor: middle; fill: #111; }
.by-f .f0 polygon, .by-t .t0 polygon, .by-n .n0 polygon { fill: #cfe3f2; }
.by-f .f1 polygon, .by-t .t1 polygon, .by-n .n1 polygon { fill: #fee391; }
.by-f .f2 polygon, .by-t .t2 polygon, .by-n .n2 polygon { fill: #fec44f; }
.by-f .f3 polygon, .by-t .t3 polygon, .by-n .n3 polygon { fill: #fe9929; }
.by-f .f4 polygon, .by-t .t4 polygon, .by-n .n4 polygon { fill: #d95f0e; }
.by-f .f5 polygon, .by-t .t5 polygon, .by-n .n5 polygon { fill: #8c2d04; }
.by-f .f5 text, .by-t .t5 text, .by-n .n5 text { fill: #fff; }
.heat-legend i { display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid var(--line); vertical-align: -0.1em;
  print-color-adjust: exact; }
i.h0 { background: #cfe3f2; } i.h1 { background: #fee391; } i.h2 { background: #fec44f; } i.h3 { background: #fe9929; }
i.h4 { background: #d95f0e; } i.h5 { background: #8c2d04; }
.heat-legend { display: none; }
.heat-maps.by-f .of-f, .heat-maps.by-t .of-t, .heat-maps.by-n .of-n { display: flex; }
)";

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

std::string render_campaign_page(const FinishedCampaign& campaign, const CampaignFigures& figures,
                                 MapOfWorld map_of_world) {
  const std::string body =
      headline_html(campaign, figures) + specification_section(campaign.spec) + plots_notice() +
      unscored_section(figures) + figures_section(figures) + pairs_section(figures) +
      recovery_section(figures) + heat_section(campaign, figures, map_of_world) +
      worst_section(campaign, figures) +
      html_section("Costs",
                   "<p>CPU time and memory differ in every repetition and have a page of their "
                   "own: <a href=\"costs.html\">costs.html</a></p>\n");
  return html_page({.title = campaign.spec.name,
                    .body = body,
                    .body_class = "figures",
                    .style = kHeatStyle,
                    .bundle = campaign_bundle()});
}

CampaignPages render_campaign_pages(const FinishedCampaign& campaign) {
  const CampaignFigures figures = gather_figures(campaign);
  return {{"campaign.html", render_campaign_page(campaign, figures, map_of_cell)},
          {"costs.html", render_cost_page(campaign, figures.figures.axes())}};
}

}  // namespace castaway::testbed
