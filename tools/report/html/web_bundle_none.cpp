// Built instead of the bundles where there is no Node.js.
#include "tools/report/html/web_bundle.hpp"

namespace castaway::testbed {

std::optional<WebBundle> player_bundle() { return std::nullopt; }

std::optional<WebBundle> plots_bundle() { return std::nullopt; }

}  // namespace castaway::testbed
