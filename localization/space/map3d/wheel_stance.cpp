#include "localization/space/map3d/wheel_stance.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace castaway::localization {
namespace {

constexpr double kReach = 0.15;     // [m] Distance of the contacts from base.
constexpr double kTouch = 1e-6;     // [m] A contact this deep in the ground touches it.
constexpr double kSmallest = 1e-4;  // [m^2] Twice the area of a tripod; less is a line.

Eigen::Vector3d under_feet(const std::array<std::size_t, 3>& feet,
                           std::span<const double> heights) {
  return {heights[feet[0]], heights[feet[1]], heights[feet[2]]};
}

/// Points ahead, behind and beside.
std::vector<Eigen::Vector2d> around_base() {
  return {{kReach, 0.0}, {-kReach, 0.0}, {0.0, kReach}, {0.0, -kReach}};
}

}  // namespace

WheelStance::WheelStance() : contacts_(around_base()) {}

WheelStance::WheelStance(std::vector<Eigen::Vector2d> contacts, const Eigen::Vector3d& p_base_com)
    : contacts_(std::move(contacts)), p_base_com_(p_base_com) {
  if (contacts_.size() > kMost) contacts_.resize(kMost);
  const std::size_t n = contacts_.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        Eigen::Matrix3d feet;
        feet << contacts_[i].transpose(), 1.0, contacts_[j].transpose(), 1.0,
            contacts_[k].transpose(), 1.0;
        if (std::abs(feet.determinant()) < kSmallest) continue;
        tripods_.push_back({{i, j, k}, feet.inverse()});
      }
    }
  }
  if (tripods_.empty()) contacts_ = around_base();
}

/// True if no contact is in the ground.
bool WheelStance::is_above(const Eigen::Vector3d& plane, std::span<const double> heights) const {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].dot(plane.head<2>()) + plane.z() < heights[i] - kTouch) return false;
  }
  return true;
}

/// The least of the shares of the load on the feet; negative if the robot would fall over an edge.
double WheelStance::stability(const Tripod& tripod, const Eigen::Vector3d& plane) const {
  const Eigen::Vector2d p_base_load = p_base_com_.head<2>() - p_base_com_.z() * plane.head<2>();
  const Eigen::Vector3d shares = tripod.plane_of_heights.transpose() * p_base_load.homogeneous();
  return shares.minCoeff();
}

StandingPlane WheelStance::rest(std::span<const double> heights) const {
  if (tripods_.empty()) {
    return {0.0, (heights[0] - heights[1]) / (2.0 * kReach),
            (heights[2] - heights[3]) / (2.0 * kReach)};
  }
  Eigen::Vector3d most_stable = Eigen::Vector3d::Zero();
  double most = -std::numeric_limits<double>::infinity();
  for (const Tripod& tripod : tripods_) {
    const Eigen::Vector3d plane = tripod.plane_of_heights * under_feet(tripod.feet, heights);
    if (!is_above(plane, heights)) continue;
    const double stable = stability(tripod, plane);
    if (stable <= most) continue;
    most = stable;
    most_stable = plane;
  }
  return {most_stable.z(), most_stable.x(), most_stable.y()};
}

}  // namespace castaway::localization
