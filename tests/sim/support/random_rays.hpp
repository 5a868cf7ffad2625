/// Points and directions drawn evenly, for tests of rays.
#pragma once

#include <Eigen/Core>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "sim/common/random.hpp"

namespace castaway::sim {

/// A point in the cube from -reach to reach, [m], drawn evenly.
inline Eigen::Vector3d random_point(double reach, Rng& rng) {
  boost::random::uniform_real_distribution<double> any(-reach, reach);
  const double x = any(rng);
  const double y = any(rng);
  return {x, y, any(rng)};
}

/// A unit vector, drawn evenly from the sphere.
inline Eigen::Vector3d random_direction(Rng& rng) {
  boost::random::normal_distribution<double> normal;
  const double x = normal(rng);
  const double y = normal(rng);
  return Eigen::Vector3d(x, y, normal(rng)).normalized();
}

}  // namespace castaway::sim
