#include "tools/live/live_log.hpp"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/build/build_localizers.hpp"
#include "tools/build/ros2/bridge_messages.hpp"
#include "tools/live/live_event.hpp"
#include "tools/play/replay/splice_target.hpp"

namespace castaway::testbed {
namespace {

constexpr double kRecordedRadius = 0.2;  // [m] Of the outlines on the map: a log does not tell.

/// The scan of {"splice": {"to_scan": 900}}; nothing for another event.
std::optional<std::size_t> splice_of(const std::string& event) {
  const auto json = nlohmann::json::parse(event, nullptr, false);
  if (!json.is_object() || json.size() != 1 || !json.contains("splice")) return std::nullopt;
  const auto& body = json["splice"];
  const bool good = body.is_object() && body.size() == 1 && body.contains("to_scan") &&
                    body["to_scan"].is_number_unsigned();
  if (!good) throw std::runtime_error(R"(a splice is {"to_scan": 900}, a scan of the log)");
  return body["to_scan"].get<std::size_t>();
}

YamlNode splice_event(const LogJump& jump) {
  return parse_yaml(
      fmt::format("splice: {{after_scans: {}, to_scan: {}}}", jump.after_scans, jump.to_scan),
      "splice");
}

std::vector<YamlNode> orders_in(const YamlNode& session) {
  std::vector<YamlNode> orders;
  const YamlNode* events = session.find("events");
  if (events == nullptr) return orders;
  for (const YamlNode& event : events->items) {
    if (event.find("localizer") != nullptr) orders.push_back(event);
  }
  return orders;
}

void set_key(YamlNode& map, const std::string& key, YamlNode value) {
  map.entries.remove_if([&](const YamlEntry& entry) { return entry.key == key; });
  map.entries.push_back({key, std::move(value)});
}

/// So that a saved session can be played from anywhere.
void make_absolute(YamlNode& session, const std::string& key) {
  const YamlNode* file = session.find(key);
  if (file == nullptr || file->scalar.empty()) return;
  set_key(session, key, write_yaml(std::filesystem::absolute(file->scalar).string()));
}

}  // namespace

LiveLog::LiveLog(ReplaySession session, const LiveSinkMaker& make_sink, TopicWriter* bridge)
    : session_(std::move(session)), log_(open_log(session_)), orders_(orders_in(session_.tree)) {
  source_ = spliced_source(log_, session_);
  sinks_.push_back(make_sink(run_info(session_, log_), log_.map, kRecordedRadius));
  LocalizerPlace place{log_.map, session_.map, log_.lidars, {}};
  place.volume = log_.volume;
  localizers_ = build_localizers(session_.localizers, place, session_.seed);
  LoopConfig config;
  config.start = initial_pose(session_, log_, *source_);
  config.orders = session_.orders;
  loop_ = std::make_unique<Loop>(std::move(config), localizers_, sinks_);
  loop_->begin();
  if (bridge != nullptr) {
    BridgeConfig told;
    told.start = initial_pose(session_, log_, *source_);
    told.messages.lidars = bag_lidars(log_.lidars);
    sinks_.push_back(
        std::make_unique<BridgeMessages>(run_info(session_, log_), log_.map, told, *bridge));
  }
  step();  // Stamps of a log may begin late.
}

std::size_t LiveLog::target_of(const sim::KidnapSpec& kidnap) const {
  using sim::KidnapKind;
  const std::size_t from = source_->last_scan();
  if (kidnap.target && kidnap.kind == KidnapKind::kTeleportTo) {
    const auto on_level = [&](double z) {
      if (!kidnap.level || !log_.levels) return true;
      return level_at(*log_.levels, z) == static_cast<std::size_t>(*kidnap.level);
    };
    return nearest_scan(*log_.frames, {kidnap.target->x, kidnap.target->y, kidnap.target->yaw},
                        on_level);
  }
  if (kidnap.kind == KidnapKind::kTeleportRandom) {
    return far_scan(*log_.frames, from, kidnap.min_distance_m);
  }
  if (kidnap.kind == KidnapKind::kLookAlike) {
    return look_alike_scan(*log_.frames, from, kidnap.min_distance_m);
  }
  throw std::runtime_error("a recorded log can be spliced only: 'teleport' or 'look_alike'");
}

void LiveLog::add_orders(const std::string& event) {
  LiveEvent added = read_live_event(event, now(), 1);
  for (const LocalizerOrder& order : added.specs.orders) loop_->add(order);
  orders_.push_back(std::move(added.node));
}

bool LiveLog::step() {
  const bool more = loop_->step(*source_);
  loop_->require_outputs();
  return more;
}

Stamp LiveLog::add(const std::string& event) {
  if (const auto to_scan = splice_of(event)) {
    source_->jump(*to_scan);
    return now();
  }
  const EventSpecs specs = read_live_event(event, now(), 1).specs;
  const std::vector<sim::KidnapSpec>& kidnaps = specs.simulated.kidnaps;
  if (!kidnaps.empty()) {
    source_->jump(target_of(kidnaps.front()));
  } else if (!specs.orders.empty()) {
    add_orders(event);
  } else {
    throw std::runtime_error(
        "a recorded log can be spliced, and its localizers restarted; no more");
  }
  return now();
}

std::string LiveLog::saved() const {
  YamlNode session = session_.tree;
  for (const char* key : {"log", "map", "map3d"}) make_absolute(session, key);
  set_key(session, "scans",
          write_yaml(static_cast<std::uint64_t>(std::max<std::size_t>(1, source_->played()))));
  YamlNode events;
  events.kind = YamlNode::Kind::kList;
  for (const LogJump& jump : source_->jumps()) events.items.push_back(splice_event(jump));
  events.items.insert(events.items.end(), orders_.begin(), orders_.end());
  set_key(session, "events", std::move(events));
  return emit_yaml(session);
}

}  // namespace castaway::testbed
