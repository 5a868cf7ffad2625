#include "tools/live/served_nodes.hpp"

#include <iterator>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/scenario/localizers/ros2_yaml.hpp"
#include "tools/scenario/localizers/yaml_json.hpp"

namespace castaway::testbed {

void check_nodes(const std::vector<LocalizerSpec>& localizers) {
  for (const LocalizerSpec& localizer : localizers) {
    const auto* node = std::get_if<Ros2Config>(&localizer.config);
    if (node == nullptr || !node->drive) continue;
    throw std::invalid_argument("localizer '" + localizer.name +
                                "': a node does not drive a live run; use castaway run");
  }
}

void serve_nodes(const YamlNode& settings, std::vector<LocalizerSpec>& localizers) {
  const YamlNode* list = settings.find("localizers");
  for (std::size_t i = 0; i < localizers.size(); ++i) {
    const auto* node = std::get_if<Ros2Config>(&localizers[i].config);
    if (node == nullptr) continue;
    const YamlNode& item = *std::next(list->items.begin(), static_cast<std::ptrdiff_t>(i));
    ProgramConfig program;
    program.command = {"/proc/self/exe", "serve", json_text(yaml_json(item))};
    program.start_timeout_s = 2.0 * node->start_timeout_s;
    program.timeout_s = node->start_timeout_s + node->timeout_s + 10.0;  // The first scan repeats.
    localizers[i].config = std::move(program);
  }
}

}  // namespace castaway::testbed
