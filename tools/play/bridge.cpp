#include "tools/play/bridge.hpp"

#include <algorithm>

#include "tools/play/terminal.hpp"

namespace castaway::testbed {

BridgeConfig bridge_config(const BridgeOptions& options,
                           const std::vector<LocalizerSpec>& localizers) {
  BridgeConfig config;
  config.options = options;
  config.warn = print_warning;
  config.without_robot = std::ranges::any_of(localizers, [&](const LocalizerSpec& localizer) {
    const auto* node = std::get_if<Ros2Config>(&localizer.config);
    return node != nullptr && node->domain == options.domain &&
           node->name_space == options.name_space;
  });
  return config;
}

}  // namespace castaway::testbed
