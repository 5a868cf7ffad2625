#include "tools/scenario/sections/event_list.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "tools/scenario/sections/fault_events.hpp"
#include "tools/scenario/sections/kidnap_events.hpp"
#include "tools/scenario/sections/operator_events.hpp"
#include "tools/scenario/sections/world_events.hpp"

namespace castaway::testbed {
namespace {

/// A sort of events: `- <name>: {...}`.
struct EventSort {
  std::string name;
  std::function<void(Settings settings)> describe;
  std::function<void(YamlReader body, EventSpecs& events)> read;
};

template <typename Spec>
void describe_as(Settings settings) {
  Spec spec;
  fields(std::move(settings), spec);
}

EventSort world_sort(const std::string& name) {
  return {name,
          [name](Settings settings) {
            sim::WorldChange change;
            fields(std::move(settings), name, "", change);
          },
          [name](YamlReader body, EventSpecs& events) {
            std::vector<sim::WorldChange>& changes = events.simulated.changes;
            const std::string given_name = name + "-" + std::to_string(changes.size() + 1);
            changes.push_back(read_world_change(name, std::move(body), given_name));
          }};
}

/// All of them, in the order of docs/settings.md.
std::vector<EventSort> event_sorts() {
  std::vector<EventSort> sorts{
      {"kidnap", describe_as<sim::KidnapSpec>, read_kidnap},
      {"fault", describe_as<sim::FaultSpec>,
       [](YamlReader body, EventSpecs& events) {
         events.simulated.faults.push_back(read_fault(std::move(body)));
       }},
      {"drive", describe_as<sim::DriveCommand>,
       [](YamlReader body, EventSpecs& events) {
         events.simulated.commands.push_back(read_drive_command(std::move(body)));
       }},
      {"localizer", describe_as<LocalizerOrder>, [](YamlReader body, EventSpecs& events) {
         events.orders.push_back(read_localizer_order(std::move(body)));
       }}};
  for (const char* name : kWorldEvents) sorts.push_back(world_sort(name));
  return sorts;
}

std::string known_names(const std::vector<EventSort>& sorts) {
  std::vector<std::string> names;
  for (const EventSort& sort : sorts) names.push_back(sort.name);
  std::ranges::sort(names);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

EventSpecs read_events(YamlReader& root) {
  EventSpecs events;
  const std::vector<EventSort> sorts = event_sorts();
  for (YamlReader event : root.list("events")) {
    auto [name, body] = event.name_and_body();
    const auto sort = std::ranges::find(sorts, name, &EventSort::name);
    if (sort == sorts.end()) {
      event.fail("unknown event '" + name + "'; known: " + known_names(sorts));
    }
    sort->read(std::move(body), events);
  }
  std::ranges::stable_sort(events.simulated.commands, {}, &sim::DriveCommand::at_s);
  std::ranges::stable_sort(events.orders, {}, &LocalizerOrder::at);
  return events;
}

void describe_events(std::vector<SettingText>& texts) {
  for (const EventSort& sort : event_sorts()) {
    sort.describe(Settings::describing(texts, "events[]." + sort.name + "."));
  }
}

}  // namespace castaway::testbed
