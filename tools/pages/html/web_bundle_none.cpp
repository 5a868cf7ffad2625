// Built instead of the bundles if Node.js is missing.
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {

std::optional<WebBundle> player_bundle() { return std::nullopt; }

std::optional<WebBundle> plots_bundle() { return std::nullopt; }

std::optional<WebBundle> campaign_bundle() { return std::nullopt; }

std::optional<WebBundle> live_bundle() { return std::nullopt; }

}  // namespace castaway::testbed
