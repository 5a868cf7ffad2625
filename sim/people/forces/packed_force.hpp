/// The social forces of several people on one, in single precision, in loops that compilers turn
/// into vector instructions. Compiled without `errno`, which would keep square roots out of them.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/people/forces/social_force.hpp"

namespace castaway::sim {

/// A person as seen by the others.
struct PackedPerson {
  float x = 0.0F;  ///< [m]
  float y = 0.0F;
  float vx = 0.0F;  ///< [m/s]
  float vy = 0.0F;
};

/// People, coordinate by coordinate.
struct PackedPeople {
  void push_back(const PackedPerson& person);
  /// Becomes the people of `from` at these indices.
  void gather(const PackedPeople& from, const std::vector<std::size_t>& indices);
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] PackedPerson operator[](std::size_t i) const { return {x[i], y[i], vx[i], vy[i]}; }

  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> vx;
  std::vector<float> vy;
};

/// Forces [m/s^2], coordinate by coordinate.
struct PackedForces {
  std::vector<float> x;
  std::vector<float> y;
};

/// Sets `margins` to how far people `begin` to `end` - 1 are within the cut-off of a person [m^2]:
/// negative only where `social_force` is zero, and in most such places.
void cut_off(const SocialForceConfig& config, PackedPerson person, const PackedPeople& others,
             std::size_t begin, std::size_t end, std::vector<float>& margins);

/// Sets `forces` to `social_force` of each of the others on a person.
void packed_forces(const SocialForceConfig& config, PackedPerson person, const PackedPeople& others,
                   PackedForces& forces);

}  // namespace castaway::sim
