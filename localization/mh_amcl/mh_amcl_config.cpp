#include "localization/mh_amcl/mh_amcl_config.hpp"

#include <stdexcept>
#include <string>

namespace castaway::localization {
namespace {

void require_probability(double value, const char* name) {
  if (value > 0.0 && value <= 1.0) return;
  throw std::invalid_argument(std::string(name) + " must be above 0 and at most 1");
}

}  // namespace

MhAmclConfig config_on_3d_maps() {
  MhAmclConfig config;
  config.posterior.null.left_out_as_listed = true;
  config.create.quick_candidates = 40;
  config.create.settled_beams = 24;
  config.tracking.sigma = 0.035;
  config.evidence.endpoint.sigma = 0.06;
  config.motion.trans_per_rad = 0.1;
  config.reseed.ridge_steps = 10;
  config.blind_half_life = 30.0;
  return config;
}

void validate(const MhAmclConfig& config) {
  validate(config.input);
  if (!(config.max_distance > 0.0)) throw std::invalid_argument("max_distance must be positive");
  require_probability(config.match.confident, "confident");
  require_probability(config.lost_and_found.found, "found");
  require_probability(config.lost_and_found.stays, "stays");
  if (config.match.slice < 1) throw std::invalid_argument("slice must be at least 1");
  if (config.watch.slice < 1 || config.watch.burst < 1) {
    throw std::invalid_argument("watch slice and burst must be at least 1");
  }
  if (!(config.blind_half_life >= 0.0)) {
    throw std::invalid_argument("blind_half_life must not be negative");
  }
  if (config.track_by != TrackingError::kDistance && config.belief != BeliefKind::kParticles) {
    throw std::invalid_argument("track_by weighs particles: it needs the belief particles");
  }
  if (config.history < 1) throw std::invalid_argument("history must be at least 1");
  validate(config.motion);
  validate(config.tracking);
  validate(config.evidence.endpoint);
  validate(config.refinement);
  validate(config.reseed);
  validate(config.matcher);
  validate(config.budget);
  validate(config.mixture);
  validate(config.ndt);
}

std::optional<MixtureConfig> mixture_of(const MhAmclConfig& config) {
  if (config.belief == BeliefKind::kGaussians) return config.mixture;
  return std::nullopt;
}

}  // namespace castaway::localization
