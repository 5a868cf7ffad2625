#include "tools/live/live_event.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "castaway/stamp.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/scenario/sections/event_list.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// The event, checked for what a list of events in YAML may not hold from outside.
Json parse_event(const std::string& text) {
  Json event = Json::parse(text, nullptr, false);
  if (!event.is_object() || event.size() != 1 || !event.front().is_object()) {
    throw std::runtime_error("an event is one kind with its settings: {\"kidnap\": {...}}");
  }
  for (const auto& [key, value] : event.front().items()) {
    const bool plain = value.is_number() || value.is_boolean() || value.is_string() ||
                       (value.is_array() && value.size() <= 3);
    if (!plain) throw std::runtime_error("'" + key + "' of an event is not a plain value");
  }
  if (event.front().contains("at_s")) {
    throw std::runtime_error("an event takes place now: leave 'at_s' out");
  }
  return event;
}

/// Names an object that is put into the world.
void name_object(std::size_t number, Json& event) {
  const std::string kind = event.begin().key();
  if (kind != "box" && kind != "cylinder") return;
  if (!event.front().contains("name")) event.front()["name"] = kind + "-" + std::to_string(number);
}

}  // namespace

LiveEvent read_live_event(const std::string& json, localization::Stamp at, std::size_t number) {
  Json event = parse_event(json);
  name_object(number, event);
  event.front()["at_s"] = localization::seconds(at);
  const Json list = {{"events", Json::array({std::move(event)})}};
  // JSON is YAML.
  YamlDocument document = YamlDocument::parse(json_text(list), "hand");
  YamlReader root = document.root();
  LiveEvent result;
  result.specs = read_events(root);
  document.reject_unknown_keys();
  result.node = parse_yaml(document.effective(), "hand").find("events")->items.front();
  return result;
}

}  // namespace castaway::testbed
