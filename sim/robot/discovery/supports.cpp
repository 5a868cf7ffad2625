#include "sim/robot/discovery/supports.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "sim/robot/urdf/part_points.hpp"
#include "xacro/files/lower_case.hpp"

namespace castaway::sim {
namespace {

// [m] Parts lower than this above the floor support the robot.
constexpr double kFloorReach = 0.01;
constexpr double kLift = 0.0005;            // [m]
constexpr double kSameCaster = 0.02;        // [m]
constexpr double kMinCasterRadius = 0.005;  // [m]
constexpr double kInnerShare = 0.15;        // Share of the distance between axle and casters.
constexpr double kOuterShare = 0.85;
constexpr double kWorthTelling = 0.001;  // [m] A smaller shift gets no warning.

/// The caster that replaces a part; nothing if the part does not reach the floor.
std::optional<Caster> caster_of(const RobotPart& part, double wheel_radius) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : part_points(part)) box.extend(p);
  const auto* sphere = std::get_if<SphereShape>(&part.shape);
  const double low =
      sphere != nullptr ? part.T_base_part.translation().z() - sphere->radius : box.min().z();
  if (low > kFloorReach) return std::nullopt;
  const double radius = sphere != nullptr ? sphere->radius
                                          : std::clamp(0.5 * box.sizes().z(), kMinCasterRadius,
                                                       std::max(wheel_radius, kMinCasterRadius));
  return Caster{{box.center().x(), box.center().y(), radius}, radius};
}

bool is_known_caster(const std::vector<Caster>& casters, const Caster& caster) {
  return std::any_of(casters.begin(), casters.end(), [&caster](const Caster& c) {
    return (c.p_base_caster - caster.p_base_caster).head<2>().norm() < kSameCaster;
  });
}

void add_default_caster(RobotModel& robot) {
  const double com = robot.p_base_com.x() - robot.p_base_axle.x();
  const double reach = std::max(0.35 * robot.track, 2.0 * std::abs(com));
  const double radius = std::min(0.5 * robot.wheel_radius, 0.02);
  const double x = robot.p_base_axle.x() + (com > 1e-3 ? reach : -reach);
  robot.casters.push_back({{x, robot.p_base_axle.y(), radius}, radius});
  robot.warnings.push_back(
      fmt::format("no caster reaches the floor: one was put at x = {:.3f} m", x));
}

/// Casters in front and behind would take the load off the wheels.
void lift_if_on_both_sides(RobotModel& robot) {
  bool front = false;
  bool back = false;
  for (const Caster& caster : robot.casters) {
    (caster.p_base_caster.x() > robot.p_base_axle.x() ? front : back) = true;
  }
  if (!front || !back) return;
  for (Caster& caster : robot.casters) caster.p_base_caster.z() += kLift;
}

/// Range along x in which the centre of mass is supported.
std::pair<double, double> supported_range(const RobotModel& robot) {
  double low = robot.wheels.front().p_base_wheel.x();
  double high = low;
  for (const DriveWheel& wheel : robot.wheels) {
    low = std::min(low, wheel.p_base_wheel.x());
    high = std::max(high, wheel.p_base_wheel.x());
  }
  for (const Caster& caster : robot.casters) {
    low = std::min(low, caster.p_base_caster.x());
    high = std::max(high, caster.p_base_caster.x());
  }
  return {low, high};
}

}  // namespace

void find_casters(RobotModel& robot, const std::set<std::string>& swivels) {
  std::erase_if(robot.collisions, [&](const RobotPart& part) {
    const bool could_carry = std::holds_alternative<SphereShape>(part.shape) ||
                             holds_word(part.link, {"caster", "castor"}) ||
                             swivels.contains(part.link);
    const bool is_wheel = std::any_of(robot.wheels.begin(), robot.wheels.end(),
                                      [&](const auto& wheel) { return wheel.link == part.link; });
    if (!could_carry || is_wheel) return false;
    const std::optional<Caster> caster = caster_of(part, robot.wheel_radius);
    if (caster && !is_known_caster(robot.casters, *caster)) robot.casters.push_back(*caster);
    return caster.has_value();
  });
  if (robot.casters.empty() && robot.wheels.size() == 2) add_default_caster(robot);
  lift_if_on_both_sides(robot);
}

void balance(RobotModel& robot) {
  const auto [low, high] = supported_range(robot);
  const double axle = robot.p_base_axle.x();
  // With support on one side only, some load is kept on the caster and most on the wheels.
  const bool front = high - axle > kSameCaster;
  const bool back = axle - low > kSameCaster;
  const double first =
      back ? axle + kOuterShare * (low - axle) : axle + kInnerShare * (high - axle);
  const double last =
      front ? axle + kOuterShare * (high - axle) : axle + kInnerShare * (low - axle);
  const double x = std::clamp(robot.p_base_com.x(), std::min(first, last), std::max(first, last));
  const double side = 0.25 * robot.track;
  const double y =
      std::clamp(robot.p_base_com.y(), robot.p_base_axle.y() - side, robot.p_base_axle.y() + side);
  const double moved = std::hypot(x - robot.p_base_com.x(), y - robot.p_base_com.y());
  if (moved == 0.0) return;
  if (moved > kWorthTelling) {
    const bool stands = robot.p_base_com.x() >= low && robot.p_base_com.x() <= high &&
                        std::abs(robot.p_base_com.y() - robot.p_base_axle.y()) <= 2.0 * side;
    robot.warnings.push_back(fmt::format(
        "centre of mass moved from ({:.3f}, {:.3f}) to ({:.3f}, {:.3f}) m: {}",
        robot.p_base_com.x(), robot.p_base_com.y(), x, y,
        stands ? "so close to the edge of its support, the robot would tip when it brakes"
               : "wheels and casters did not support it"));
  }
  robot.p_base_com.x() = x;
  robot.p_base_com.y() = y;
}

}  // namespace castaway::sim
