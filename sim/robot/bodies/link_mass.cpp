#include "sim/robot/bodies/link_mass.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr double kGuessedDensity = 300.0;  // [kg/m^3] Of links without mass: half-empty boxes.

/// Guesses the mass of the box around points. [kg]
double guessed_mass(const std::vector<Eigen::Vector3d>& points_base) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points_base) box.extend(p);
  return std::clamp(kGuessedDensity * box.volume(), 0.02, 50.0);
}

Eigen::Matrix3d to_matrix(const urdf::Inertial& i) {
  Eigen::Matrix3d inertia;
  inertia << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  return inertia;
}

}  // namespace

BodyMass link_mass(const urdf::Link& link, const LinkFrames& frames,
                   const std::vector<Eigen::Vector3d>& points_base,
                   std::vector<std::string>& warnings) {
  const Eigen::Isometry3d& T_base_link = frames.at(link.name);
  const bool has_mass =
      link.inertial && link.inertial->mass > 0.0 && std::isfinite(link.inertial->mass);
  if (has_mass && possible_inertia(to_matrix(*link.inertial))) {
    const Eigen::Isometry3d T = T_base_link * to_transform(link.inertial->origin);
    const Eigen::Matrix3d R = T.linear();
    return {link.inertial->mass, T.translation(), R * to_matrix(*link.inertial) * R.transpose()};
  }
  if (points_base.empty() && !has_mass) return {};
  const double mass = has_mass ? link.inertial->mass : guessed_mass(points_base);
  warnings.push_back(
      fmt::format("link {}: no valid inertia: using that of a box of {:.2f} kg", link.name, mass));
  BodyMass body = box_mass(points_base, mass);
  if (points_base.empty()) body.p_base_com = T_base_link.translation();
  return body;
}

}  // namespace castaway::sim
