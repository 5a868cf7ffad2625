#include "castaway/frame.hpp"

#include <algorithm>
#include <array>

namespace castaway::testbed {
namespace {

constexpr std::array<const char*, 15> kNames = {
    "kidnap",  "pick-up",  "collision",        "fault on",  "fault off",
    "driving", "void",     "alarm on",         "alarm off", "recovery",
    "warning", "operator", "localizer failed", "node",      "world"};

}  // namespace

std::string event_name(EventKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<EventKind> event_kind(const std::string& name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<EventKind>(found - kNames.begin());
}

}  // namespace castaway::testbed
