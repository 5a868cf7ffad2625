/// Uniformly distributed points and directions for tests of ray casts.
#pragma once

#include <Eigen/Core>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "sim/common/random.hpp"

namespace castaway::sim {

/// A uniformly distributed point [m] in the cube from -reach to reach.
inline Eigen::Vector3d random_point(double reach, Rng& rng) {
  boost::random::uniform_real_distribution<double> any(-reach, reach);
  const double x = any(rng);
  const double y = any(rng);
  return {x, y, any(rng)};
}

/// A unit vector, uniformly distributed on the sphere.
inline Eigen::Vector3d random_direction(Rng& rng) {
  boost::random::normal_distribution<double> normal;
  const double x = normal(rng);
  const double y = normal(rng);
  return Eigen::Vector3d(x, y, normal(rng)).normalized();
}

}  // namespace castaway::sim
