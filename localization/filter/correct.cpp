#include "localization/filter/correct.hpp"

namespace castaway::localization {

void correct(ParticleSet& particles, const EndpointModel& model, const ScanPoints& points) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.log_weights[i] += model.log_likelihood(points, particles.poses[i]);
  }
}

}  // namespace castaway::localization
