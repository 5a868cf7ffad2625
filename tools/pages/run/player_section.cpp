#include "tools/pages/run/player_section.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/html.hpp"
#include "tools/pages/html/html_page.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/pages/run/kidnap_section.hpp"
#include "tools/run/event_names.hpp"
#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// [x, y], and the height in a run on several floors.
Json point(const std::optional<localization::SE2>& pose, const std::optional<double>& z) {
  if (!pose) return nullptr;
  Json json{pose->x, pose->y};
  if (z) json.push_back(*z);
  return json;
}

Json page_of(const RunFolder& run) {
  const RecoveryConfig right;
  Json events = Json::array();
  for (const ReportEvent& event : run.events) {
    const EventNames names = names_of(event.what);
    events.push_back({{"time", event.stamp_s},
                      {"kind", names.kind},
                      {"detail", names.detail},
                      {"localizer", event.localizer},
                      {"from", point(event.T_map_from, event.from_z)},
                      {"to", point(event.T_map_to, event.to_z)}});
  }
  const std::optional<double> open_s = opening_time(run);
  return {{"right_m", right.position_m},
          {"right_rad", right.yaw_rad},
          {"open_s", open_s ? Json(*open_s) : Json()},
          {"events", events}};
}

}  // namespace

bool has_player(const RunFolder& run) { return player_bundle() && !run.recording.empty(); }

std::string player_section(const RunFolder& run) {
  if (!player_bundle()) {
    return "<p class=\"soft\">This page has no player and no plots: castaway was built without "
           "Node.js. Install nodejs and npm, configure and build again, then <code>castaway "
           "report</code> "
           "on this folder.</p>\n";
  }
  if (run.recording.empty()) {
    return plots_notice() +
           "<p class=\"soft\">This page has no player: the run left no recording.gz "
           "(<code>outputs.player</code>).</p>\n";
  }
  return plots_notice() + "<div class=\"live\" hidden>\n" +
         html_section("Player", "<div id=\"castaway-player\"></div>\n") + "</div>\n";
}

std::string player_curves(const RunFolder& run) {
  if (!has_player(run)) return "";
  return "<div class=\"live\" hidden>\n" +
         html_section(
             "Curves",
             "<div class=\"curves-head\"><p class=\"soft\">A click moves the player; drag to "
             "zoom all curves, double-click for all of the run. Dotted across: 0.5 m and 0.35 "
             "rad (20°), above which an output is wrong. Dashed down: kidnaps and faults; dotted "
             "down: recoveries; strips along the bottom: alarms.</p><button type=\"button\" "
             "id=\"castaway-zoom\">All of the run</button></div>\n"
             "<div id=\"castaway-curves\"></div>\n") +
         "</div>\n";
}

std::string player_data(const RunFolder& run) {
  if (!has_player(run)) return "";
  return fmt::format(
      "<script type=\"application/json\" id=\"castaway-page\">{}</script>\n"
      "<script type=\"text/plain\" id=\"castaway-recording\">{}</script>\n",
      script_json(page_of(run)), base64(run.recording));
}

}  // namespace castaway::testbed
