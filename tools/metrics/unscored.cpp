#include "tools/metrics/unscored.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/metrics/recovery.hpp"

namespace castaway::testbed {

std::string unscored_sentence(const nlohmann::ordered_json& recovery) {
  const auto each = recovery.find("each");
  if (each == recovery.end() || !each->is_array()) return "";
  int count = 0;
  const char* noun = "kidnap";
  for (const auto& event : *each) {
    if (!event.is_object() || event.value("scored", true)) continue;
    if (event.value("kind", "") == kOperatorKind) continue;
    ++count;
    if (event.value("kind", "") == "start") noun = "event";
  }
  if (count == 0) return "";
  return fmt::format(
      "{} {}{} not scored: less than {:.0f} s before the next one, an operator's order, or the "
      "end of the run",
      count, noun, count == 1 ? " is" : "s are", seconds(RecoveryConfig{}.min_left));
}

}  // namespace castaway::testbed
