#include "tools/scenario/sections/amcl_spec.hpp"

#include <stdexcept>

namespace castaway::testbed {
namespace {

using localization::AmclConfig;
using localization::AmclSensorModel;

/// `laser_model_type`.
AmclSensorModel read_model(YamlReader& body, AmclSensorModel fallback) {
  const std::vector<std::string> names = {"likelihood_field", "likelihood_field_prob", "beam"};
  const std::string name =
      body.choice("laser_model_type", names[static_cast<std::size_t>(fallback)], names);
  if (name == "beam") return AmclSensorModel::kBeam;
  return name == "likelihood_field" ? AmclSensorModel::kLikelihoodField
                                    : AmclSensorModel::kLikelihoodFieldProb;
}

/// The beam model's own keys; z_hit, z_rand and sigma_hit are those of the likelihood field.
void read_beam_model(YamlReader& body, AmclConfig& config) {
  config.beam.z_hit = config.sensor.z_hit;
  config.beam.z_rand = config.sensor.z_rand;
  config.beam.sigma_hit = config.sensor.sigma_hit;
  config.beam.z_short = body.get("z_short", config.beam.z_short);
  config.beam.z_max = body.get("z_max", config.beam.z_max);
  config.beam.lambda_short = body.get("lambda_short", config.beam.lambda_short);
}

void read_beam_skip(YamlReader& body, localization::BeamSkipConfig& skip) {
  skip.enabled = body.get("do_beamskip", skip.enabled);
  skip.distance = body.get("beam_skip_distance", skip.distance);
  skip.threshold = body.get("beam_skip_threshold", skip.threshold);
  skip.error_threshold = body.get("beam_skip_error_threshold", skip.error_threshold);
}

}  // namespace

const std::vector<std::string>& amcl_presets() {
  static const std::vector<std::string> kPresets = {"amcl", "amcl-recovery", "amcl-global",
                                                    "amcl-prob"};
  return kPresets;
}

AmclConfig amcl_preset(const std::string& preset) {
  AmclConfig config;
  if (preset == "amcl-recovery") config.recovery = {0.001, 0.1};
  if (preset == "amcl-prob") config.model = AmclSensorModel::kLikelihoodFieldProb;
  return config;
}

AmclConfig read_amcl(YamlReader& body, const std::string& preset) {
  AmclConfig config = amcl_preset(preset);
  config.model = read_model(body, config.model);
  config.motion.alpha1 = body.get("alpha1", config.motion.alpha1);
  config.motion.alpha2 = body.get("alpha2", config.motion.alpha2);
  config.motion.alpha3 = body.get("alpha3", config.motion.alpha3);
  config.motion.alpha4 = body.get("alpha4", config.motion.alpha4);
  config.sensor.z_hit = body.get("z_hit", config.sensor.z_hit);
  config.sensor.z_rand = body.get("z_rand", config.sensor.z_rand);
  config.sensor.sigma_hit = body.get("sigma_hit", config.sensor.sigma_hit);
  read_beam_model(body, config);
  config.sensor.max_distance = body.get("laser_likelihood_max_dist", config.sensor.max_distance);
  config.kld.min_particles = body.get("min_particles", config.kld.min_particles);
  config.kld.max_particles = body.get("max_particles", config.kld.max_particles);
  config.kld.error = body.get("pf_err", config.kld.error);
  config.kld.z = body.get("pf_z", config.kld.z);
  config.recovery.alpha_slow = body.get("recovery_alpha_slow", config.recovery.alpha_slow);
  config.recovery.alpha_fast = body.get("recovery_alpha_fast", config.recovery.alpha_fast);
  read_beam_skip(body, config.beam_skip);
  config.update_min_d = body.get("update_min_d", config.update_min_d);
  config.update_min_a = body.get("update_min_a", config.update_min_a);
  config.max_beams = body.get("max_beams", config.max_beams);
  config.max_range = body.get("laser_max_range", config.max_range);
  config.update_at_rest = body.get("update_at_rest", config.update_at_rest);
  config.half_cell_shift = body.get("half_cell_shift", config.half_cell_shift);
  try {
    validate(config);
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
  return config;
}

}  // namespace castaway::testbed
