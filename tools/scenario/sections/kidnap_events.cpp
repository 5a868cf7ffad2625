#include "tools/scenario/sections/kidnap_events.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using sim::HeldWheels;
using sim::KidnapKind;
using sim::KidnapTrigger;

// Doors closed for 15 s, nothing to see; brakes on.
constexpr sim::LiftConfig kElevatorRide{0.01, 15.0, 1.0, HeldWheels::kLocked, true};
constexpr sim::LiftConfig kPalletTruckRide{0.1, 4.0, 1.2, HeldWheels::kLocked, false};
constexpr double kKidnapDegree = std::numbers::pi / 180.0;

/// A teleport to a pose is one that states it.
std::vector<std::pair<std::string, KidnapKind>> kidnap_kinds() {
  std::vector<std::pair<std::string, KidnapKind>> kinds;
  for (const KidnapKind kind :
       {KidnapKind::kTeleportRandom, KidnapKind::kLookAlike, KidnapKind::kNudge, KidnapKind::kTurn,
        KidnapKind::kCarry, KidnapKind::kSpin, KidnapKind::kElevator, KidnapKind::kPalletTruck}) {
    kinds.emplace_back(part_name(kind), kind);
  }
  return kinds;
}

/// The four keys for the trigger of a kidnap, of which one is given.
void trigger_fields(Settings& settings, KidnapTrigger& trigger) {
  const std::vector<std::pair<Setting, KidnapTrigger::On>> keys{
      {{"at_s", "s", "Simulated time.", {0.0, kLongest}}, KidnapTrigger::On::kTime},
      {{"at_m", "m", "Distance driven.", {0.0, kFarthest}}, KidnapTrigger::On::kDistance},
      {{"poisson_s", "s", "Mean interval of random kidnaps.", {0.1, kLongest}},
       KidnapTrigger::On::kPoisson},
      {{"when_localized_s",
        "s",
        "The watched localizer has been right for this long.",
        {0.0, kLongest}},
       KidnapTrigger::On::kLocalized}};
  std::vector<KidnapTrigger> found;
  for (const auto& [about, on] : keys) {
    std::optional<double> value;
    if (settings.optional(about, value)) found.push_back({on, *value});
  }
  if (!settings.describes() && found.size() != 1) {
    settings.fail("give one of 'at_s', 'at_m', 'poisson_s' and 'when_localized_s'");
  }
  if (!found.empty()) trigger = found.front();
  trigger.times = trigger.on == KidnapTrigger::On::kPoisson ? 0 : 1;
  settings.field({"times", "", "Number of kidnaps; 0: until the run ends.", {0.0, 1e6}},
                 trigger.times);
}

void bounds_field(Settings& settings, const Setting& about, sim::Bounds& bounds) {
  Eigen::Vector2d pair(bounds.min, bounds.max);
  settings.field(about, pair);
  bounds = {pair.x(), pair.y()};
}

void lift_fields(Settings& settings, KidnapKind kind, sim::LiftConfig& lift) {
  if (kind == KidnapKind::kSpin) lift.height = 0.05;
  if (kind == KidnapKind::kElevator) lift = kElevatorRide;
  if (kind == KidnapKind::kPalletTruck) lift = kPalletTruckRide;
  settings.field({"lift_m", "m", "Height to which the robot is lifted.", {0.0, 100.0}},
                 lift.height);
  settings.field({"lift_s", "s", "Time to lift it, and to put it down.", {1e-3, 1e4}},
                 lift.seconds);
  const bool carried = kind == KidnapKind::kCarry || kind == KidnapKind::kPalletTruck;
  if (carried || settings.describes()) {
    settings.field({"speed", "m/s", "Speed at which it is carried.", {1e-3, 100.0}}, lift.speed);
  }
  settings.choice({"wheels", "", "State of the wheels in the air."}, lift.wheels,
                  {{"driven", HeldWheels::kDriven},
                   {"free", HeldWheels::kFree},
                   {"locked", HeldWheels::kLocked}});
  settings.field({"covered", "", "The person who carries it covers the lidars."}, lift.covered);
}

/// Target of a kidnap, for the kinds that move the robot far.
void target_fields(Settings& settings, sim::KidnapSpec& kidnap) {
  if (kidnap.kind != KidnapKind::kLookAlike) {
    std::optional<Eigen::Vector3d> pose;
    settings.optional({"pose",
                       "m, rad",
                       "Target pose: x, y, yaw in map; random if missing.",
                       {-kFarthest, kFarthest}},
                      pose);
    if (pose) kidnap.target = sim::Pose2{pose->x(), pose->y(), pose->z()};
  }
  if (!settings.describes() && kidnap.kind != KidnapKind::kLookAlike) {
    settings.optional({"level", "", "Floor of the target, from 0.", {0, 255}}, kidnap.level);
  }
  if (!kidnap.target) {
    settings.field({"ramp", "", "A random target is on a ramp."}, kidnap.ramp);
  }
  if (kidnap.target && settings.has("min_distance_m")) {
    settings.fail("give 'pose' or 'min_distance_m', not both");
  }
  if (!kidnap.target) {
    settings.field({"min_distance_m", "m", "Minimum distance of a random target.", {0.0, 1e5}},
                   kidnap.min_distance_m);
  } else if (kidnap.kind == KidnapKind::kTeleportRandom) {
    kidnap.kind = KidnapKind::kTeleportTo;
  }
}

void turn_field(Settings& settings, sim::KidnapSpec& kidnap) {
  sim::Bounds degrees{45.0, 180.0};
  bounds_field(settings,
               {"angle_deg", "deg", "Minimum and maximum angle of a turn.", {1e-6, 360.0}},
               degrees);
  kidnap.turn = {degrees.min * kKidnapDegree, degrees.max * kKidnapDegree};
}

}  // namespace

void fields(Settings settings, sim::KidnapSpec& kidnap) {
  const bool all = settings.describes();
  settings.choice({"kind", "", "What happens to the robot."}, kidnap.kind, kidnap_kinds());
  const KidnapKind kind = kidnap.kind;
  trigger_fields(settings, kidnap.when);
  const bool lifted = kind == KidnapKind::kCarry || kind == KidnapKind::kSpin ||
                      kind == KidnapKind::kElevator || kind == KidnapKind::kPalletTruck;
  const bool stays = kind == KidnapKind::kNudge || kind == KidnapKind::kTurn;
  if (all || kind == KidnapKind::kNudge) {
    bounds_field(settings,
                 {"distance_m", "m", "Minimum and maximum distance of a nudge.", {1e-6, 1e5}},
                 kidnap.nudge);
  }
  if (all || kind == KidnapKind::kTurn) turn_field(settings, kidnap);
  if (all || lifted) lift_fields(settings, kind, kidnap.lift);
  if (all || kind == KidnapKind::kElevator) {
    settings.optional({"level", "", "Floor of the target, from 0.", {0, 255}}, kidnap.level);
  }
  const bool in_place = stays || kind == KidnapKind::kSpin || kind == KidnapKind::kElevator;
  if (all || !in_place) target_fields(settings, kidnap);
  settings.field({"power_cycle", "",
                  "Sensors are off from pick-up to put-down, then odometry "
                  "starts from zero."},
                 kidnap.power_cycle);
  settings.form({"localizer", "", "Localizer that `when_localized_s` watches."}, "the first");
}

void read_kidnap(YamlReader body, EventSpecs& events) {
  sim::KidnapSpec kidnap;
  fields(Settings::reading(body), kidnap);
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
  events.simulated.kidnaps.push_back(kidnap);
}

bool waits_for_localizer(const EventSpecs& events) {
  return std::ranges::any_of(events.simulated.kidnaps, [](const auto& kidnap) {
    return kidnap.when.on == KidnapTrigger::On::kLocalized;
  });
}

}  // namespace castaway::testbed
