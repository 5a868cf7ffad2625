#include "localization/filter/kld_resample.hpp"

#include <algorithm>
#include <set>

#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::localization {

ParticleSet kld_resample(const ParticleSet& particles, const KldConfig& config,
                         const FreeSpace& anywhere, double random_share, Rng& rng) {
  std::vector<double> cumulated = normalized_weights(particles);
  for (std::size_t i = 1; i < cumulated.size(); ++i) cumulated[i] += cumulated[i - 1];
  boost::random::uniform_real_distribution<double> unit(0.0, 1.0);
  ParticleSet next;
  std::set<PoseBin> bins;
  while (static_cast<int>(next.size()) < config.max_particles) {
    if (unit(rng) < random_share) {
      next.poses.push_back(anywhere.sample(rng));
    } else {
      const auto drawn = std::upper_bound(cumulated.begin(), cumulated.end() - 1, unit(rng));
      next.poses.push_back(particles.poses[static_cast<std::size_t>(drawn - cumulated.begin())]);
    }
    next.log_weights.push_back(0.0);
    bins.insert(bin_of(config, next.poses.back()));
    if (static_cast<int>(next.size()) > kld_limit(config, bins.size())) break;
  }
  return next;
}

}  // namespace castaway::localization
