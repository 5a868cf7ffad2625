#include "sim/robot/bodies/inertia.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace castaway::sim {
namespace {

constexpr double kMinEdge = 0.02;  // [m]

/// Inertia of a point mass at `p` about the origin.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& p) {
  return mass * (p.squaredNorm() * Eigen::Matrix3d::Identity() - p * p.transpose());
}

}  // namespace

bool possible_inertia(const Eigen::Matrix3d& inertia) {
  if (!inertia.allFinite()) return false;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  return moments.minCoeff() > 0.0 && moments.maxCoeff() <= 1.01 * (moments[0] + moments[1]);
}

BodyMass box_mass(const std::vector<Eigen::Vector3d>& points_base, double mass) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points_base) box.extend(p);
  if (points_base.empty()) box.extend(Eigen::Vector3d::Zero().eval());
  const Eigen::Vector3d s = box.sizes().cwiseMax(kMinEdge).cwiseAbs2();
  const Eigen::Vector3d moments(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
  return {mass, box.center(), (mass / 12.0 * moments).asDiagonal()};
}

BodyMass lump(const std::vector<BodyMass>& bodies) {
  BodyMass sum;
  for (const BodyMass& body : bodies) {
    sum.mass += body.mass;
    sum.p_base_com += body.mass * body.p_base_com;
  }
  if (sum.mass <= 0.0) return sum;
  sum.p_base_com /= sum.mass;
  for (const BodyMass& body : bodies) {
    sum.inertia += body.inertia + point_inertia(body.mass, body.p_base_com - sum.p_base_com);
  }
  return sum;
}

}  // namespace castaway::sim
