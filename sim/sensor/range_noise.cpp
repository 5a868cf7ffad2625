#include "sim/sensor/range_noise.hpp"

#include <boost/random/normal_distribution.hpp>

namespace castaway::sim {

double measured_range(const RangeNoise& noise, double range, Rng& rng) {
  if (noise.sigma <= 0.0) return range;
  return range + boost::random::normal_distribution<double>(0.0, noise.sigma)(rng);
}

}  // namespace castaway::sim
