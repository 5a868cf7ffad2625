/// What draws people on and keeps them apart.
///
/// D. Helbing and P. Molnar, "Social Force Model for Pedestrian Dynamics", 1995: the driving force
/// (eq. 2) and walls that push (eq. 5, with the distance to the nearest wall). M. Moussaid, D.
/// Helbing, S. Garnier, A. Johansson, M. Combe and G. Theraulaz, "Experimental Study of the
/// Behavioural Mechanisms Underlying Self-Organization in Human Crowds", 2009: the interaction
/// (eqs. 3 to 6).
/// Differences: forces end beyond `reach`, and contacts are resolved by displacement
/// (`separation.hpp`) instead of stiff springs, so that 50 ms are a step small enough.
#pragma once

#include <Eigen/Core>

namespace castaway::sim {

/// Strengths and ranges. Forces are per unit of mass.
struct SocialForceConfig {
  double relaxation = 0.5;      ///< [s] In which a person gets up to speed.
  double social = 2.1;          ///< [m/s^2] A, strength of the interaction.
  double gamma = 0.35;          ///< [1] Range of the interaction over |D|.
  double lambda = 2.0;          ///< [1] Weight of the relative velocity in D; [s] by its unit.
  double n = 2.0;               ///< [1] Angular range of the turn aside.
  double n_prime = 3.0;         ///< [1] Angular range of slowing down.
  double reach = 5.0;           ///< [m] Beyond, people do not mind each other.
  double obstacle = 10.0;       ///< [m/s^2] Of a wall that touches.
  double obstacle_range = 0.2;  ///< [m] In which that falls to 1/e.
};

/// Helbing and Molnar, eq. 2: towards the desired velocity.
Eigen::Vector2d driving_force(const SocialForceConfig& config, const Eigen::Vector2d& velocity,
                              const Eigen::Vector2d& desired_velocity);

/// Moussaid et al. 2009, eqs. 3 to 6, on a person with the other at `offset` [m] from it, which it
/// approaches with `approach` = its velocity - the other's [m/s]. Zero for an offset of zero.
Eigen::Vector2d social_force(const SocialForceConfig& config, const Eigen::Vector2d& offset,
                             const Eigen::Vector2d& approach);

/// Helbing and Molnar, eq. 5, of a wall with a free way of `gap` [m] to it (from the body's
/// surface), `away`: the unit vector off it.
Eigen::Vector2d obstacle_force(const SocialForceConfig& config, double gap,
                               const Eigen::Vector2d& away);

}  // namespace castaway::sim
