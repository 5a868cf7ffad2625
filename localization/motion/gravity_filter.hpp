/// The direction up in base, from an inertial measurement unit.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "castaway/stamp.hpp"

namespace castaway::localization {

/// Parameters of the filter.
struct GravityConfig {
  double memory = 1.0;      ///< [s] Time constant by which the specific force corrects the gyro.
  double smoothing = 0.25;  ///< [s] Time constant of the force that checks the direction.
  /// [rad] A check that differs more says that the direction is not known now: the robot
  /// accelerates, or stands on other ground than the gyro says.
  double doubt = 0.05;
  double patience = 0.4;  ///< [s] After so long, the direction of the check is taken.
};

/// A complementary filter: turns by the gyro, corrected by the specific force.
///
/// R. Mahony, T. Hamel, J.-M. Pflimlin, "Nonlinear complementary filters on the special orthogonal
/// group", IEEE Transactions on Automatic Control 53, 2008, without its estimate of the bias.
class GravityFilter {
 public:
  explicit GravityFilter(const GravityConfig& config = {}) : config_(config) {}

  /// Takes a reading in base: [rad/s], [m/s^2]. Not finite values, and those of a time before, are
  /// dropped; after a gap of more than 0.5 s the filter begins anew.
  void add(Stamp stamp, const Eigen::Vector3d& angular_velocity, const Eigen::Vector3d& force);
  /// Begins anew.
  void clear() { stamp_.reset(); }
  /// The unit vector that points up; nothing while it is not known.
  [[nodiscard]] std::optional<Eigen::Vector3d> up() const;

 private:
  GravityConfig config_;
  std::optional<Stamp> stamp_;  ///< Of the newest reading.
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d check_ = Eigen::Vector3d::UnitZ();  ///< Smoothed direction of the force.
  double age_ = 0.0;                                  ///< [s] Since the beginning.
  double doubted_ = 0.0;                              ///< [s] For how long the check has differed.
};

}  // namespace castaway::localization
