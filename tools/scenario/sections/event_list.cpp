#include "tools/scenario/sections/event_list.hpp"

#include <algorithm>
#include <string>

#include "tools/scenario/sections/fault_events.hpp"
#include "tools/scenario/sections/kidnap_events.hpp"
#include "tools/scenario/sections/operator_events.hpp"
#include "tools/scenario/sections/world_events.hpp"

namespace castaway::testbed {

EventSpecs read_events(YamlReader& root) {
  EventSpecs events;
  for (YamlReader event : root.list("events")) {
    auto [kind, body] = event.name_and_body();
    if (kind == "kidnap") {
      read_kidnap(body, events);
    } else if (kind == "fault") {
      events.faults.push_back(read_fault(body));
    } else if (kind == "drive") {
      events.commands.push_back(read_drive_command(body));
    } else if (kind == "localizer") {
      events.orders.push_back(read_localizer_order(body));
    } else if (is_world_event(kind)) {
      const std::string name = kind + "-" + std::to_string(events.changes.size() + 1);
      events.changes.push_back(read_world_change(kind, body, name));
    } else {
      event.fail("unknown event '" + kind +
                 "'; known: box, cylinder, door, drive, fault, kidnap, localizer, people, remove");
    }
  }
  std::ranges::stable_sort(events.commands, {}, &sim::DriveCommand::at_s);
  std::ranges::stable_sort(events.orders, {}, &LocalizerOrder::at);
  return events;
}

}  // namespace castaway::testbed
