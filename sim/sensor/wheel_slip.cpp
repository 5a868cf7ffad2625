#include "sim/sensor/wheel_slip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <boost/random/exponential_distribution.hpp>

namespace castaway::sim {
namespace {

constexpr double kMostSlip = 0.95;  // A wheel with more slip would be stuck.
constexpr double kPatch = 0.25;     // [m] Distance over which a zone's slip is constant.

/// Draws nothing from an empty range, so that a spread of 0 shifts no later draw.
double draw_factor(double low, double high, Rng& rng) {
  return low < high ? draw_between(low, high, rng) : low;
}

double way_to_event(const SlipConfig& config, Rng& rng) {
  if (config.rate <= 0.0) return kNoSlip;
  return boost::random::exponential_distribution<double>(config.rate)(rng);
}

}  // namespace

bool contains(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

WheelSlip::WheelSlip(const SlipConfig& config, const DriveGeometry& drive,
                     std::vector<SlipZone> zones, Rng rng)
    : config_(config), zones_(std::move(zones)), rng_(rng) {
  validate(config);
  if (!config.zones) zones_.clear();
  const Eigen::Vector2d half(0.0, 0.5 * drive.track);
  wheels_[0] = {drive.radius_left, drive.p_base_axle + half, way_to_event(config_, rng_)};
  wheels_[1] = {drive.radius_right, drive.p_base_axle - half, way_to_event(config_, rng_)};
}

void WheelSlip::start_event(Wheel& wheel, double length) {
  wheel.event_left = length;
  wheel.event_share = std::min(draw_factor(0.0, 2.0 * config_.share, rng_), kMostSlip);
}

double WheelSlip::zone_share(Wheel& wheel, double way, const Pose2& T_map_base) {
  double slip = 0.0;
  for (const SlipZone& zone : zones_) {
    if (contains(zone.outline, T_map_base * wheel.p_base)) slip = std::max(slip, zone.slip);
  }
  if (slip <= 0.0) return 0.0;
  wheel.zone_left -= way;
  if (wheel.zone_left <= 0.0) {
    wheel.zone_left = kPatch;
    wheel.zone_factor = draw_factor(1.0 - config_.zone_spread, 1.0 + config_.zone_spread, rng_);
  }
  return std::min(slip * wheel.zone_factor, kMostSlip);
}

double WheelSlip::count(Wheel& wheel, double angle, const Pose2& T_map_base) {
  const double way = std::abs(angle) * wheel.radius;
  wheel.next_event -= way;
  if (wheel.next_event <= 0.0) {
    wheel.next_event = way_to_event(config_, rng_);
    start_event(wheel, config_.length);
  }
  double share = zone_share(wheel, way, T_map_base);
  if (wheel.event_left > 0.0) share = std::max(share, wheel.event_share);
  wheel.event_left -= way;
  return angle / (1.0 - share);
}

WheelAngles WheelSlip::count(const WheelAngles& increment, const Pose2& T_map_base,
                             std::int64_t collisions) {
  if (collisions > collisions_ && config_.collision_length > 0.0) {
    for (Wheel& wheel : wheels_) start_event(wheel, config_.collision_length);
  }
  collisions_ = collisions;
  return {count(wheels_[0], increment.left, T_map_base),
          count(wheels_[1], increment.right, T_map_base)};
}

}  // namespace castaway::sim
