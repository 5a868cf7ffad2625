/// The social force model: what drives people and what keeps them apart.
///
/// D. Helbing and P. Molnar, "Social Force Model for Pedestrian Dynamics", 1995: the driving force
/// (eq. 2) and the force of walls (eq. 5, with the distance to the nearest wall). M. Moussaid, D.
/// Helbing, S. Garnier, A. Johansson, M. Combe and G. Theraulaz, "Experimental Study of the
/// Behavioural Mechanisms Underlying Self-Organization in Human Crowds", 2009: the interaction
/// (eqs. 3 to 6).
/// Differences: forces end beyond `reach`, and contacts are resolved by displacement
/// (`separation.hpp`) instead of stiff springs, so that a step of 50 ms is small enough.
#pragma once

#include <Eigen/Core>

namespace castaway::sim {

/// Cut-off: where an exponential of the model is below exp(-kNegligible), it is taken as 0. A force
/// that is left out is below 0.0074 m/s^2 between people, 0.025 m/s^2 at walls.
inline constexpr double kNegligible = 6.0;

/// Strengths and ranges. Forces are per unit of mass.
struct SocialForceConfig {
  double relaxation = 0.5;  ///< [s] Time constant of acceleration to the desired velocity.
  double social = 2.1;      ///< [m/s^2] A, strength of the interaction.
  double gamma = 0.35;      ///< [1] Range of the interaction over |D|.
  double lambda = 2.0;      ///< [1] Weight of the relative velocity in D; its unit makes it [s].
  double n = 2.0;           ///< [1] Angular range of the turn aside.
  double n_prime = 3.0;     ///< [1] Angular range of slowing down.
  double reach = 5.0;       ///< [m] Farther people do not affect each other.
  double obstacle = 10.0;   ///< [m/s^2] Force of a wall at contact.
  double obstacle_range = 0.2;  ///< [m] Distance within which that falls to 1/e.
};

/// Helbing and Molnar, eq. 2: accelerates towards the desired velocity.
Eigen::Vector2d driving_force(const SocialForceConfig& config, const Eigen::Vector2d& velocity,
                              const Eigen::Vector2d& desired_velocity);

/// Moussaid et al. 2009, eqs. 3 to 6: force on a person by another one at `offset` [m] from it.
/// `approach` is its velocity minus the other's [m/s]. Zero for an offset of zero.
Eigen::Vector2d social_force(const SocialForceConfig& config, const Eigen::Vector2d& offset,
                             const Eigen::Vector2d& approach);

/// Helbing and Molnar, eq. 5: force of a wall at a distance of `gap` [m] from the body's surface.
/// `away` is the unit vector away from the wall.
Eigen::Vector2d obstacle_force(const SocialForceConfig& config, double gap,
                               const Eigen::Vector2d& away);

}  // namespace castaway::sim
