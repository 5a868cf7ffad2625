/// The report's player as the build bundled it from web/.
#pragma once

#include <optional>
#include <string_view>

namespace castaway::testbed {

/// What a page embeds. Neither text holds the end of its own tag.
struct WebBundle {
  std::string_view script;
  std::string_view style;
};

/// Nothing where the program was built without Node.js.
std::optional<WebBundle> web_bundle();

}  // namespace castaway::testbed
