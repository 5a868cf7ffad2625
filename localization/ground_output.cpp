#include "localization/ground_output.hpp"

#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr double kBelowAll = -1e6;  // [m]

/// Replaces a pose, and returns what base stands on there.
std::optional<Footing> take_to_map(const Volume& volume, SE2& pose) {
  std::optional<Footing> footing;
  if (const auto there = volume.lift(pose)) {
    footing = Footing{there->T_map_base.translation().z(), static_cast<int>(there->level)};
  }
  pose = volume.atlas().in_map(pose);
  return footing;
}

}  // namespace

PoseWithCovariance in_atlas(const Volume& volume, const PoseWithCovariance& start) {
  const double z = start.z.value_or(kBelowAll);
  const auto there = volume.atlas().to_atlas(start.T_map_base, z);
  if (!there) throw std::invalid_argument("there is no drivable ground at the start");
  return {*there, start.covariance, start.z};
}

void to_map(const Volume& volume, std::optional<Estimate>& estimate) {
  if (!estimate) return;
  estimate->footing = take_to_map(volume, estimate->T_map_base);
  for (Alternative& alternative : estimate->alternatives) {
    alternative.footing = take_to_map(volume, alternative.T_map_base);
  }
}

void to_map(const Volume& volume, Diagnostics& diagnostics) {
  for (PopulationView& population : diagnostics.populations) {
    population.footing = take_to_map(volume, population.T_map_base);
    for (SE2& pose : population.particles) pose = volume.atlas().in_map(pose);
  }
}

}  // namespace castaway::localization
