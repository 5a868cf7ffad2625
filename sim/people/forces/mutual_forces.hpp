/// The social forces among all people at once.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "sim/people/forces/social_force.hpp"

namespace castaway::sim {

/// Where people are and how they move.
struct Crowding {
  std::vector<Eigen::Vector2d> positions;   ///< [m] In map.
  std::vector<Eigen::Vector2d> velocities;  ///< [m/s]
};

/// Up to so many people, all pairs are summed in double precision.
inline constexpr std::size_t kFewPeople = 50;

/// Sum of the social forces (`social_force`) of all others on each person [m/s^2]; the forces of
/// two people on each other are opposite. Takes `forces_of_pairs` for up to `kFewPeople`, else
/// `forces_of_neighbours`.
std::vector<Eigen::Vector2d> mutual_forces(const SocialForceConfig& config, const Crowding& people);

/// In double precision. Quadratic in the number of people.
std::vector<Eigen::Vector2d> forces_of_pairs(const SocialForceConfig& config,
                                             const Crowding& people);

/// In single precision, four at a time, among the people in cells within
/// `SocialForceConfig::reach`: for people of a given density, linear in their number. Each of two
/// people's forces differs from `social_force` by less than 0.001 m/s^2 within 100 m, and by the
/// force itself, 0.0074 m/s^2 at most, where rounding moves it across the cut-off.
std::vector<Eigen::Vector2d> forces_of_neighbours(const SocialForceConfig& config,
                                                  const Crowding& people);

}  // namespace castaway::sim
