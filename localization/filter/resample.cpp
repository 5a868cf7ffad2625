#include "localization/filter/resample.hpp"

#include <cassert>

#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::localization {

std::vector<std::size_t> systematic_resample(const std::vector<double>& weights, std::size_t count,
                                             Rng& rng) {
  assert(!weights.empty());
  std::vector<std::size_t> indices(count);
  boost::random::uniform_real_distribution<double> unit(0.0, 1.0);
  const double first = unit(rng);
  double cumulated = weights[0];
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double u = (first + static_cast<double>(k)) / static_cast<double>(count);
    while (u >= cumulated && i + 1 < weights.size()) cumulated += weights[++i];
    indices[k] = i;
  }
  return indices;
}

}  // namespace castaway::localization
