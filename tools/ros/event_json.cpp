#include "tools/ros/event_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json pose_json(const SE2& pose) { return {pose.x, pose.y, pose.yaw}; }

std::optional<SE2> pose_of(const Json& json, const char* key) {
  if (!json.contains(key)) return std::nullopt;
  const Json& pose = json.at(key);
  return SE2{pose.at(0).get<double>(), pose.at(1).get<double>(), pose.at(2).get<double>()};
}

/// Parses a time; nothing if it is unreasonably large.
std::optional<Stamp> stamp_of(const Json& json) {
  constexpr double kLongest = 1e9;
  const auto time_s = json.get<double>();
  return std::abs(time_s) < kLongest ? std::optional(localization::from_seconds(time_s))
                                     : std::nullopt;
}

}  // namespace

std::string event_json(const RunEvent& event) {
  const EventNames names = names_of(event.what);
  Json json = {{"kind", names.kind}, {"detail", names.detail}, {"stamp_s", seconds(event.stamp)}};
  if (event.since) json["since_s"] = seconds(*event.since);
  if (event.T_map_from) json["from"] = pose_json(*event.T_map_from);
  if (event.T_map_to) json["to"] = pose_json(*event.T_map_to);
  if (const auto* kidnap = event.as<KidnapEvent>(); kidnap != nullptr && kidnap->heights) {
    json["heights"] = {kidnap->heights->x(), kidnap->heights->y()};
  }
  return json_text(json);
}

std::optional<RunEvent> event_of_json(const std::string& text) {
  if (nests_too_deep(text)) return std::nullopt;
  const Json json = Json::parse(text, nullptr, false);
  try {
    RunEvent event;
    const auto what =
        event_named(json.at("kind").get<std::string>(), json.at("detail").get<std::string>());
    if (!what) return std::nullopt;
    event.what = *what;
    const std::optional<Stamp> stamp = stamp_of(json.at("stamp_s"));
    if (!stamp) return std::nullopt;
    event.stamp = *stamp;
    if (json.contains("since_s")) event.since = stamp_of(json.at("since_s"));
    event.T_map_from = pose_of(json, "from");
    event.T_map_to = pose_of(json, "to");
    auto* kidnap = std::get_if<KidnapEvent>(&event.what);
    if (kidnap != nullptr && json.contains("heights")) {
      const Json& z = json.at("heights");
      kidnap->heights = {{z.at(0).get<double>(), z.at(1).get<double>()}};
    }
    return event;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace castaway::testbed
