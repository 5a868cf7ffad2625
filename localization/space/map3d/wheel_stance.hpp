/// How a robot stands on ground that is not level: on which of its wheels, and how tilted.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace castaway::localization {

/// The plane on which a robot stands, above the ground under base.
struct StandingPlane {
  double z = 0.0;       ///< [m] At base.
  double along = 0.0;   ///< Rise per metre along x of base.
  double across = 0.0;  ///< The same along y of base.
};

/// Where a robot touches the ground, and on what it rests. A rigid robot with more than three
/// wheels rests on three of them, those around its centre of mass.
class WheelStance {
 public:
  static constexpr std::size_t kMost = 12;  ///< Contacts that are used.

  /// Wheels are not known: the ground 0.15 m ahead of, behind and beside base tilts the robot.
  WheelStance();
  /// `contacts` [m]: where wheels and casters touch level ground, in base. As if they were not
  /// known if there are not three that do not lie on a line.
  /// `p_base_com` [m]: the centre of mass.
  WheelStance(std::vector<Eigen::Vector2d> contacts, const Eigen::Vector3d& p_base_com);

  /// [m] Points under which the height of the ground counts, in base.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& contacts() const { return contacts_; }
  [[nodiscard]] const Eigen::Vector3d& p_base_com() const { return p_base_com_; }
  [[nodiscard]] bool is_known() const { return !tripods_.empty(); }
  /// The plane on which the robot stands: on twisted ground it may be stable in two ways, and is
  /// taken to stand in the one from which it falls least easily. `heights` [m]: of the ground under
  /// the contacts, above that under base.
  [[nodiscard]] StandingPlane rest(std::span<const double> heights) const;

 private:
  /// Three contacts. Heights under them give a plane.
  struct Tripod {
    std::array<std::size_t, 3> feet{};
    Eigen::Matrix3d plane_of_heights = Eigen::Matrix3d::Identity();
  };

  [[nodiscard]] bool is_above(const Eigen::Vector3d& plane, std::span<const double> heights) const;
  [[nodiscard]] double stability(const Tripod& tripod, const Eigen::Vector3d& plane) const;

  std::vector<Eigen::Vector2d> contacts_;
  Eigen::Vector3d p_base_com_ = Eigen::Vector3d::Zero();
  std::vector<Tripod> tripods_;  ///< Empty: wheels are not known.
};

}  // namespace castaway::localization
