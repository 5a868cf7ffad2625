#include "localization/filter/predict.hpp"

namespace castaway::localization {

void predict(ParticleSet& particles, const OdometryMotion& motion, Rng& rng) {
  for (SE2& pose : particles.poses) pose = motion.sample(pose, rng);
}

}  // namespace castaway::localization
