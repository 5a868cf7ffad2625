/// Scripts and styles of pages as the build bundled them from web/.
#pragma once

#include <optional>
#include <string_view>

namespace castaway::testbed {

/// What a page embeds. Neither text holds the end of its own tag.
struct WebBundle {
  std::string_view script;
  std::string_view style;
};

/// The report's player, and all plots. Nothing where the program was built without Node.js.
std::optional<WebBundle> player_bundle();

/// The plots alone, for pages without a player. Nothing without Node.js.
std::optional<WebBundle> plots_bundle();

}  // namespace castaway::testbed
