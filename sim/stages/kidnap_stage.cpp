#include "sim/stages/kidnap_stage.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/common/seconds.hpp"
#include "sim/events/level_target.hpp"
#include "sim/map/level_plane.hpp"
#include "sim/navigation/level_planner.hpp"
#include "sim/navigation/planner.hpp"
#include "sim/people/bodies/person.hpp"
#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

// [m] Least distance between the bodies of robot and person.
constexpr double kClearOfPeople = 0.1;

bool takes_time(const KidnapSpec& spec) {
  return spec.kind == KidnapKind::kCarry || spec.kind == KidnapKind::kSpin ||
         spec.kind == KidnapKind::kElevator || spec.kind == KidnapKind::kPalletTruck;
}

bool is_carried(const KidnapSpec& spec) {
  return spec.kind == KidnapKind::kCarry || spec.kind == KidnapKind::kPalletTruck;
}

/// The random stream of a kidnap's times; empty for triggers that draw nothing.
Rng clock_stream(const KidnapSpec& spec, std::size_t index, const NamedStreams& streams) {
  if (spec.when.on != KidnapTrigger::On::kPoisson) return Rng();
  if (!streams) {
    throw std::invalid_argument(
        "kidnaps at random times: no random streams for them: give SimulationStreams::named");
  }
  return streams(fmt::format("events/kidnap/{}", index));
}

/// Throws before the run if a given target can never be reached.
void check_target(const KidnapSpec& spec, const Pose2& start, const FreeSpace& free) {
  if (!spec.target) return;
  Rng unused;
  KidnapSpec there = spec;
  there.kind = KidnapKind::kTeleportTo;
  kidnap_target(there, {start, free}, unused);
}

/// Points of the ground in map on the way of a carried robot; empty if there is none.
std::vector<Eigen::Vector3d> carried_path(const FreeSpace& space, const Pose2& from,
                                          const Pose2& to) {
  if (space.levels() != nullptr) {
    return plan_over_levels(space, from.position(), to.position(), {})
        .value_or(std::vector<Eigen::Vector3d>{});
  }
  std::vector<Eigen::Vector3d> path;
  const auto planar = plan_path(space, from.position(), to.position());
  if (!planar) return path;
  for (const Eigen::Vector2d& p : *planar) path.emplace_back(p.x(), p.y(), 0.0);
  return path;
}

TriggerInput trigger_input(const KidnapInput& input) {
  return {to_seconds(input.now), input.driven, input.localized};
}

}  // namespace

KidnapStage::KidnapStage(const SimulationConfig& config, Spaces& spaces, const RayScene& scene,
                         const NamedStreams& streams)
    : landing_([&config, &spaces](double radius) { return spaces.landing(config, radius); }),
      footprint_(config.robot.footprint_radius),
      streams_(streams),
      scene_(&scene),
      lidar_(config.lidars.front()),
      keep_clear_(config.robot.footprint_radius + PersonBody{}.radius + kClearOfPeople) {
  for (const KidnapSpec& spec : config.events.kidnaps) add(spec, config.start);
}

void KidnapStage::add(const KidnapSpec& spec, const Pose2& T_map_base) {
  validate(spec);
  const double radius = footprint_ + spec.margin_m;
  auto space = spaces_.find(radius);
  if (space == spaces_.end()) space = spaces_.emplace(radius, landing_(radius)).first;
  require_wanted_ground(spec, space->second);
  check_target(spec, T_map_base, space->second);
  if (spec.kind == KidnapKind::kLookAlike && space->second.levels() != nullptr) {
    throw std::runtime_error("kidnap look_alike: not on several levels: choose another kind");
  }
  if (is_carried(spec) && !carry_space_) carry_space_ = landing_(0.0);
  entries_.push_back({spec, {spec.when, clock_stream(spec, entries_.size(), streams_)}, radius});
}

void KidnapStage::set_world(const SimulationConfig& config, Spaces& spaces) {
  landing_ = [&config, &spaces](double radius) { return spaces.landing(config, radius); };
  for (auto& [radius, space] : spaces_) space = landing_(radius);
  if (carry_space_) carry_space_ = landing_(0.0);
  for (Entry& entry : entries_) entry.look_alikes.reset();
}

KidnapOutcome KidnapStage::advance(const KidnapInput& input, Rng& rng) {
  KidnapOutcome outcome;
  if (held_) outcome = finish(input.now);
  const TriggerInput trigger = trigger_input(input);
  for (Entry& entry : entries_) {
    const bool due = entry.clock.due(trigger);
    if (!due || held_ || outcome.done) continue;
    outcome = begin(entry, input, rng);
    if (outcome.done || outcome.picked_up) entry.clock.on_kidnap(trigger);
  }
  return outcome;
}

KidnapOutcome KidnapStage::finish(nanoseconds now) {
  const double held_for = to_seconds(now - held_->record.since);
  if (held_for < held_->lift.duration()) return {};
  KidnapOutcome outcome;
  outcome.done = held_->record;
  outcome.done->stamp = now;
  power_cycle_ = held_->spec->power_cycle;
  held_.reset();
  return outcome;
}

KidnapOutcome KidnapStage::begin(Entry& entry, const KidnapInput& input, Rng& rng) {
  KidnapScene scene{
      input.T_map_base, spaces_.at(entry.radius), {}, keep_clear_, look_alikes_of(entry)};
  if (input.people) scene.people = input.people();
  const auto target = kidnap_target(entry.spec, scene, rng);
  if (!target) return {};
  if (takes_time(entry.spec)) return begin_lift(entry, input, *target);
  power_cycle_ = entry.spec.power_cycle;
  KidnapOutcome outcome;
  outcome.done = KidnapRecord{input.now, entry.spec.kind,    input.T_map_base, target->T_map_base,
                              input.now, target->unlikeness, target->too_near};
  return outcome;
}

KidnapOutcome KidnapStage::begin_lift(const Entry& entry, const KidnapInput& input,
                                      const KidnapTarget& target) {
  const Pose2& from = input.T_map_base;
  KidnapRecord record{input.now, entry.spec.kind, from, target.T_map_base, input.now,
                      {},        target.too_near};
  Lift lift(entry.spec.lift, way_of(entry, from, target.T_map_base));
  held_ = std::make_unique<Held>(Held{&entry.spec, record, std::move(lift)});
  KidnapOutcome outcome;
  outcome.picked_up = PickUp{entry.spec.kind};
  return outcome;
}

LiftWay KidnapStage::way_of(const Entry& entry, const Pose2& from, const Pose2& to) const {
  const LevelPlane* plane = spaces_.at(entry.radius).levels();
  LiftWay way{from, to};
  if (is_carried(entry.spec)) way.path = carried_path(*carry_space_, from, to);
  if (plane == nullptr) {
    if (way.path.empty()) way.path.emplace_back(from.x, from.y, 0.0);
    return way;
  }
  way.T_map_from = plane->in_map(from);
  way.T_map_to = plane->in_map(to);
  way.z_from = plane->p_map(from.position()).z();
  way.z_to = plane->p_map(to.position()).z();
  return way;
}

const LookAlikes* KidnapStage::look_alikes_of(Entry& entry) {
  if (entry.spec.kind != KidnapKind::kLookAlike) return nullptr;
  if (!entry.look_alikes) {
    entry.look_alikes = std::make_unique<LookAlikes>(*scene_, spaces_.at(entry.radius), lidar_);
  }
  return entry.look_alikes.get();
}

Eigen::Isometry3d KidnapStage::held_at(nanoseconds stamp) const {
  return held_->lift.at(to_seconds(stamp - held_->record.since));
}

}  // namespace castaway::sim
