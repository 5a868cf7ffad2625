#include "tools/batch/trials/kidnap_trials.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "localization/geometry/random.hpp"
#include "sim/common/random.hpp"
#include "sim/stages/drive_setup.hpp"
#include "sim/stages/drive_space.hpp"
#include "sim/stages/spaces.hpp"
#include "tools/batch/trials/office_map.hpp"
#include "tools/build/scan_truth.hpp"

namespace castaway::testbed {
namespace {

constexpr double kPersonRadius = 0.25;  // [m]
constexpr double kPersonHeight = 1.8;   // [m]
constexpr double kRobotMargin = 0.1;    // [m] Free space around the footprint where the robot is
                                        // placed.
constexpr double kLeadSpread = 0.5;     // [s]
constexpr int kWaypoints = 4;
constexpr int kTries = 200;  // Attempts to draw one place.
constexpr int kCrowds = 10;  // Attempts to draw people around a place.

PreparedSimulation prepare(const KidnapTrialConfig& config) {
  validate(config);
  Scenario scenario;
  scenario.world.file = config.world;
  LidarSpec& lidar = scenario.lidars.front();
  if (config.lidar == "robot") lidar.set("rate_hz", 10.0).set("range_max", 12.0);
  lidar.profile = config.lidar;
  if (config.range_max) lidar.set("range_max", *config.range_max);
  if (config.fov_deg) lidar.set("fov_deg", *config.fov_deg);
  scenario.drive.route = "none";
  return config.world == "office" ? build_simulation(scenario, ".", draw_office())
                                  : build_simulation(scenario, ".");
}

sim::Pose2 sample_pose(const std::optional<sim::Pose2>& pose) {
  if (pose) return *pose;
  throw std::runtime_error("the world has no room for a kidnap; choose a larger one");
}

sim::WorldObject person(const Eigen::Vector2d& p_map, std::size_t number) {
  sim::WorldObject object;
  object.name = fmt::format("person_{}", number);
  object.shape = sim::CylinderShape{kPersonRadius, kPersonHeight};
  object.T_map_object.translation() = Eigen::Vector3d(p_map.x(), p_map.y(), 0.5 * kPersonHeight);
  object.in_map = false;
  return object;
}

/// Whether the robot can stand at its start and at the kidnap's target, and drive away from both.
bool can_drive(const sim::SimulationConfig& config) {
  const sim::KidnapSpec& kidnap = config.events.kidnaps.front();
  const sim::FreeSpace free(sim::drive_grid(config),
                            config.robot.footprint_radius + kidnap.margin_m);
  return free.contains(config.start.position()) &&
         (!kidnap.target || free.contains(kidnap.target->position()));
}

}  // namespace

void validate(const KidnapTrialConfig& config) {
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw std::invalid_argument(text);
  };
  require(config.lead_s >= kLeadSpread, "the lead must be at least half a second");
  require(config.window_s > 0.0, "the window must be positive");
  require(config.min_distance_m >= 0.0, "the distance of a kidnap must not be negative");
  require(config.kind != sim::KidnapKind::kTeleportTo && config.kind != sim::KidnapKind::kCarry &&
              config.kind != sim::KidnapKind::kSpin,
          "trials have kidnaps of the kinds teleport, look_alike, nudge and turn");
  require(config.near_m > 0.0 && config.far_m > config.near_m, "need 0 < near_m < far_m");
}

KidnapTrials::KidnapTrials(const KidnapTrialConfig& config)
    : config_(config),
      prepared_(prepare(config)),
      robot_space_(prepared_.config.map, prepared_.config.robot.footprint_radius + kRobotMargin),
      person_space_(prepared_.config.map, kPersonRadius) {}

sim::KidnapSpec KidnapTrials::draw_kidnap(sim::Rng& rng, const sim::Pose2& start) const {
  const sim::SimulationConfig& base = prepared_.config;
  const double way =
      sim::limits_of(base.drive, base.robot).max_speed * (config_.lead_s + kLeadSpread);
  sim::KidnapSpec kidnap;
  kidnap.when.value = config_.lead_s + sim::draw_between(-kLeadSpread, kLeadSpread, rng);
  kidnap.min_distance_m = config_.min_distance_m;
  kidnap.kind = config_.kind;
  if (kidnap.kind != sim::KidnapKind::kTeleportRandom) return kidnap;
  kidnap.kind = sim::KidnapKind::kTeleportTo;
  kidnap.target =
      sample_pose(robot_space_.sample(rng, start.position(), config_.min_distance_m + way));
  return kidnap;
}

std::vector<Eigen::Vector2d> KidnapTrials::draw_people(int count, sim::Rng& rng,
                                                       const sim::SimulationConfig& config) const {
  const Eigen::Vector2d target = config.events.kidnaps.front().target->position();
  const double from_start = config.robot.footprint_radius + kRobotMargin + kPersonRadius;
  const auto fits = [&](const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& others) {
    return person_space_.contains(p) && (p - config.start.position()).norm() > from_start &&
           std::none_of(others.begin(), others.end(), [&](const Eigen::Vector2d& other) {
             return (p - other).norm() < 2.0 * kPersonRadius;
           });
  };
  std::vector<Eigen::Vector2d> people;
  for (int tries = 0; static_cast<int>(people.size()) < count && tries < kTries * count; ++tries) {
    const double near2 = config_.near_m * config_.near_m;
    const double r = std::sqrt(sim::draw_between(near2, config_.far_m * config_.far_m, rng));
    const double heading = sim::draw_between(-std::numbers::pi, std::numbers::pi, rng);
    const Eigen::Vector2d p = target + r * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    if (fits(p, people)) people.push_back(p);
  }
  return people;
}

bool KidnapTrials::add_people(int count, sim::Rng& rng, sim::SimulationConfig& config) const {
  const auto objects = static_cast<std::ptrdiff_t>(config.world.objects.size());
  for (int tries = 0; tries < kCrowds; ++tries) {
    const std::vector<Eigen::Vector2d> people = draw_people(count, rng, config);
    for (const Eigen::Vector2d& p : people) {
      config.world.objects.push_back(person(p, config.world.objects.size()));
    }
    if (static_cast<int>(people.size()) == count && can_drive(config)) return true;
    config.world.objects.erase(config.world.objects.begin() + objects, config.world.objects.end());
  }
  return false;
}

KidnapTrial KidnapTrials::draw(int index, int obstacles) const {
  sim::Rng rng = localization::substream(config_.seed, fmt::format("kidnap/{}", index));
  sim::Rng people = localization::substream(config_.seed, fmt::format("people/{}", index));
  if (obstacles > 0 && config_.kind != sim::KidnapKind::kTeleportRandom) {
    throw std::invalid_argument(
        "obstacles stand around the target of a teleport: use --kind teleport, or no obstacles");
  }
  KidnapTrial trial{prepared_.config, rng()};
  sim::SimulationConfig& config = trial.simulation;
  config.start = sample_pose(robot_space_.sample(rng));
  config.random_start = false;
  if (obstacles > 0) config.spaces = std::make_shared<sim::Spaces>();  // Of its own world.
  for (int i = 0; i < kWaypoints; ++i) {
    config.drive.waypoints.push_back(sample_pose(robot_space_.sample(rng)).position());
  }
  for (int tries = 0; tries < kTries; ++tries) {
    config.events.kidnaps = {draw_kidnap(rng, config.start)};
    config.duration =
        localization::from_seconds(config.events.kidnaps.front().when.value + config_.window_s);
    if (obstacles == 0 || add_people(obstacles, people, config)) return trial;
  }
  throw std::runtime_error(
      fmt::format("the world has no place with room for {} people around it", obstacles));
}

std::vector<LidarFacts> KidnapTrials::lidars() const { return lidars_of(prepared_.config.lidars); }

}  // namespace castaway::testbed
