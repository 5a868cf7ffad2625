#include "tools/scenario/sections/kidnap_events.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace castaway::testbed {
namespace {

using sim::HeldWheels;
using sim::KidnapKind;
using sim::KidnapTrigger;

constexpr double kDegree = std::numbers::pi / 180.0;

template <typename Value>
Value chosen(YamlReader& body, const std::string& key, const std::string& fallback,
             const std::vector<std::pair<std::string, Value>>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  const std::string name = body.choice(key, fallback, names);
  return std::find_if(values.begin(), values.end(),
                      [&](const auto& entry) { return entry.first == name; })
      ->second;
}

KidnapKind read_kind(YamlReader& body) {
  return chosen<KidnapKind>(body, "kind", "teleport",
                            {{"teleport", KidnapKind::kTeleportRandom},
                             {"look_alike", KidnapKind::kLookAlike},
                             {"nudge", KidnapKind::kNudge},
                             {"turn", KidnapKind::kTurn},
                             {"carry", KidnapKind::kCarry},
                             {"spin", KidnapKind::kSpin}});
}

/// One of the four keys that say when.
KidnapTrigger read_trigger(YamlReader& body) {
  static const std::vector<std::pair<std::string, KidnapTrigger::On>> kKeys{
      {"at_s", KidnapTrigger::On::kTime},
      {"at_m", KidnapTrigger::On::kDistance},
      {"poisson_s", KidnapTrigger::On::kPoisson},
      {"when_localized_s", KidnapTrigger::On::kLocalized}};
  std::vector<KidnapTrigger> found;
  for (const auto& [key, on] : kKeys) {
    if (const auto value = body.get_optional<double>(key)) found.push_back({on, *value});
  }
  if (found.size() != 1) {
    body.fail("give one of 'at_s', 'at_m', 'poisson_s' and 'when_localized_s'");
  }
  KidnapTrigger trigger = found.front();
  trigger.times = body.get("times", trigger.on == KidnapTrigger::On::kPoisson ? 0 : 1);
  return trigger;
}

sim::Bounds read_bounds(YamlReader& body, const std::string& key, const sim::Bounds& fallback) {
  const auto pair = body.get(key, Eigen::Vector2d(fallback.min, fallback.max));
  return {pair.x(), pair.y()};
}

sim::LiftConfig read_lift(YamlReader& body, KidnapKind kind) {
  sim::LiftConfig lift;
  if (kind == KidnapKind::kSpin) lift.height = 0.05;
  lift.height = body.get("lift_m", lift.height);
  lift.seconds = body.get("lift_s", lift.seconds);
  if (kind == KidnapKind::kCarry) lift.speed = body.get("speed", lift.speed);
  lift.wheels = chosen<HeldWheels>(body, "wheels", "driven",
                                   {{"driven", HeldWheels::kDriven},
                                    {"free", HeldWheels::kFree},
                                    {"locked", HeldWheels::kLocked}});
  lift.covered = body.get("covered", lift.covered);
  return lift;
}

/// Where it goes, for the kinds that go far.
void read_target(YamlReader& body, sim::KidnapSpec& kidnap) {
  if (kidnap.kind != KidnapKind::kLookAlike) {
    if (const auto pose = body.get_optional<Eigen::Vector3d>("pose")) {
      kidnap.target = sim::Pose2{pose->x(), pose->y(), pose->z()};
    }
  }
  if (kidnap.target && body.has("min_distance_m")) {
    body.fail("give 'pose' or 'min_distance_m', not both");
  }
  if (!kidnap.target) kidnap.min_distance_m = body.get("min_distance_m", kidnap.min_distance_m);
  if (kidnap.target && kidnap.kind == KidnapKind::kTeleportRandom) {
    kidnap.kind = KidnapKind::kTeleportTo;
  }
}

void read_details(YamlReader& body, sim::KidnapSpec& kidnap) {
  switch (kidnap.kind) {
    case KidnapKind::kNudge:
      kidnap.nudge = read_bounds(body, "distance_m", kidnap.nudge);
      break;
    case KidnapKind::kTurn:
      kidnap.turn = read_bounds(body, "angle_deg", {45.0, 180.0});
      kidnap.turn = {kidnap.turn.min * kDegree, kidnap.turn.max * kDegree};
      break;
    case KidnapKind::kSpin:
      kidnap.lift = read_lift(body, kidnap.kind);
      break;
    case KidnapKind::kCarry:
      kidnap.lift = read_lift(body, kidnap.kind);
      read_target(body, kidnap);
      break;
    default:
      read_target(body, kidnap);
  }
}

}  // namespace

void read_kidnap(YamlReader& body, EventSpecs& events) {
  sim::KidnapSpec kidnap;
  kidnap.kind = read_kind(body);
  kidnap.when = read_trigger(body);
  read_details(body, kidnap);
  kidnap.power_cycle = body.get("power_cycle", kidnap.power_cycle);
  try {
    sim::validate(kidnap);
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
  if (kidnap.when.on == KidnapTrigger::On::kLocalized) {
    const std::string who = body.get("localizer", events.watched);
    if (!events.watched.empty() && who != events.watched) {
      body.fail("all kidnaps of a run wait for the same localizer, '" + events.watched + "'");
    }
    events.watched = who;
  }
  events.kidnaps.push_back(std::move(kidnap));
}

bool waits_for_localizer(const EventSpecs& events) {
  return std::any_of(events.kidnaps.begin(), events.kidnaps.end(), [](const auto& kidnap) {
    return kidnap.when.on == KidnapTrigger::On::kLocalized;
  });
}

}  // namespace castaway::testbed
