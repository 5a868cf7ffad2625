#include "sim/common/random.hpp"

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::sim {

double draw_between(double low, double high, Rng& rng) {
  return boost::random::uniform_real_distribution<double>(low, high)(rng);
}

double draw_normal(Rng& rng) { return boost::random::normal_distribution<double>()(rng); }

}  // namespace castaway::sim
