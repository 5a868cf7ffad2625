#include "sim/people/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace castaway::sim {
namespace {

constexpr int kBeams = 120;    // Beams evaluated, about.
constexpr double kGain = 0.2;  // Share of the error in blocked beams that a plan corrects.
constexpr double kMaxAim = 0.95;
constexpr double kCrowdSpacing = 0.42;  // [m] Least distance between two places.
constexpr int kBearings = 30;
constexpr double kCrowdGap = 0.3;  // [m] From the robot's disc to the nearest bodies.
// [m] Half the width of the lane ahead of the robot that stays free.
constexpr double kLane = 0.45;
constexpr double kAhead = 1.6;    // [m] Length of that lane.
constexpr double kLoyalty = 2.0;  // [beams] Bonus of a place where a crowd member already stands.
constexpr double kNear = 0.3;     // [m] A crowd member this close to a place stands there.

/// Gives each place to the nearest walker that has none yet.
void assign(const std::vector<Eigen::Vector2d>& places, std::vector<Agent>& agents) {
  for (Agent& agent : agents) agent.in_crowd = false;
  for (const Eigen::Vector2d& place : places) {
    Agent* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (Agent& agent : agents) {
      if (agent.errand != Errand::kWalking || agent.in_crowd) continue;
      const double distance = (agent.state.position - place).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = &agent;
    }
    if (nearest == nullptr) return;
    nearest->in_crowd = true;
    nearest->slot = place;
  }
}

}  // namespace

Crowd::Crowd(double blocked_share, const LidarConfig& lidar)
    : wanted_(blocked_share),
      aim_(blocked_share),
      lidar_(level_slice(lidar)),
      stride_(std::max(1, lidar.beams / kBeams)) {}

std::vector<Crowd::Sight> Crowd::sights(const RobotBody& robot, const Surroundings& around) const {
  const Eigen::Isometry3d T_map_base = to_isometry(robot.T_map_base);
  std::vector<Sight> result;
  for (int i = 0; i < lidar_.config().beams; i += stride_) {
    const Ray ray = lidar_.ray(T_map_base, i);
    const auto hit = around.fixed.cast(ray, lidar_.config().range_max);
    result.push_back({ray, hit ? hit->distance : lidar_.config().range_max});
  }
  return result;
}

/// Measures the blocked share, and adjusts the share aimed at by the error.
void Crowd::measure(const std::vector<Sight>& sights, const Surroundings& around) {
  const auto blocked = std::count_if(sights.begin(), sights.end(), [&](const Sight& sight) {
    return around.moving->cast(sight.ray, sight.range).has_value();
  });
  const double share = static_cast<double>(blocked) / static_cast<double>(sights.size());
  aim_ = std::clamp(aim_ + kGain * (wanted_ - share), 0.0, kMaxAim);
}

std::vector<bool> Crowd::covered_beams(const Eigen::Vector2d& p_map,
                                       const std::vector<Sight>& sights) const {
  const PersonBody body;
  const Eigen::Vector2d from = sights.front().ray.origin.head<2>();
  const Eigen::Vector2d ahead = (p_map - from).normalized();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const bool legs = sights.front().ray.origin.z() < kTorsoBottom;
  const double spread = legs ? kFootSpread : 0.0;
  const double reach = legs ? body.leg_radius : kTorsoHalfWidth;
  std::vector<bool> covers;
  for (const Sight& sight : sights) {
    const Eigen::Vector2d d = sight.ray.direction.head<2>();
    bool ends = false;
    for (const double side : {spread, -spread}) {
      const Eigen::Vector2d to = p_map + side * left - from;
      const double along = d.dot(to);
      ends = ends || (std::abs(d.x() * to.y() - d.y() * to.x()) < reach && along > 0.0 &&
                      along < sight.range);
    }
    covers.push_back(ends);
  }
  return covers;
}

std::vector<Crowd::Place> Crowd::places(const RobotBody& robot, const WalkSpace& space,
                                        const std::vector<Sight>& sights) const {
  const double inner = robot.radius + PersonBody{}.radius + kCrowdGap;
  const Pose2 T_base_map = inverse(robot.T_map_base);
  std::vector<Place> result;
  for (const double ring : {0.0, 0.3, 0.65, 1.05, 1.5}) {
    for (int i = 0; i < kBearings; ++i) {
      const double bearing = 2.0 * std::numbers::pi * i / kBearings;
      const Eigen::Vector2d p =
          robot.T_map_base.position() + (inner + ring) * heading_vector(bearing);
      const Eigen::Vector2d p_base = T_base_map * p;
      const bool lane = p_base.x() > 0.0 && p_base.x() < kAhead && std::abs(p_base.y()) < kLane;
      if (lane || !space.clear(p) || !space.sees(robot.T_map_base.position(), p)) continue;
      result.push_back({p, covered_beams(p, sights)});
    }
  }
  return result;
}

/// Uncovered beams that a place would cover; 0 if it is too near to a place already chosen.
double Crowd::gain(const Place& place, const Cover& cover, const std::vector<Agent>& agents) {
  for (const Eigen::Vector2d& other : cover.chosen) {
    if ((other - place.p_map).norm() < kCrowdSpacing) return 0.0;
  }
  double beams = 0.0;
  for (std::size_t b = 0; b < cover.covered.size(); ++b) {
    beams += place.covers[b] && !cover.covered[b] ? 1.0 : 0.0;
  }
  const bool held = std::any_of(agents.begin(), agents.end(), [&](const Agent& agent) {
    return agent.in_crowd && (agent.state.position - place.p_map).norm() < kNear;
  });
  return beams > 0.0 && held ? beams + kLoyalty : beams;
}

std::vector<Eigen::Vector2d> Crowd::choose(const std::vector<Place>& places,
                                           const std::vector<Agent>& agents) const {
  Cover cover;
  if (places.empty()) return {};
  cover.covered.assign(places.front().covers.size(), false);
  const auto wanted =
      static_cast<std::ptrdiff_t>(std::ceil(aim_ * static_cast<double>(cover.covered.size())));
  while (std::count(cover.covered.begin(), cover.covered.end(), true) < wanted) {
    const Place* best = nullptr;
    double most = 0.0;
    for (const Place& place : places) {
      const double beams = gain(place, cover, agents);
      if (beams <= most) continue;
      most = beams;
      best = &place;
    }
    if (best == nullptr) break;
    cover.chosen.push_back(best->p_map);
    for (std::size_t b = 0; b < cover.covered.size(); ++b) {
      if (best->covers[b]) cover.covered[b] = true;
    }
  }
  return cover.chosen;
}

void Crowd::plan(const RobotBody& robot, const WalkSpace& space, const Surroundings& around,
                 std::vector<Agent>& agents) {
  const std::vector<Sight> beams = sights(robot, around);
  measure(beams, around);
  assign(choose(places(robot, space, beams), agents), agents);
}

}  // namespace castaway::sim
