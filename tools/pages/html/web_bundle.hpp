/// Scripts and styles of pages, bundled from web/ by the build.
#pragma once

#include <optional>
#include <string_view>

namespace castaway::testbed {

/// Embedded content of a page. Neither text contains its own closing tag.
struct WebBundle {
  std::string_view script;
  std::string_view style;
};

/// The report's player and all plots. Nothing if the program was built without Node.js.
std::optional<WebBundle> player_bundle();

/// Only the plots, for pages without a player. Nothing if the program was built without Node.js.
std::optional<WebBundle> plots_bundle();

/// Plots with choices, tables and heat maps of a campaign. Nothing if the program was built without
/// Node.js.
std::optional<WebBundle> campaign_bundle();

/// The page of live runs. Nothing if the program was built without Node.js.
std::optional<WebBundle> live_bundle();

}  // namespace castaway::testbed
