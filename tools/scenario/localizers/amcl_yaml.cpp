#include "tools/scenario/localizers/amcl_yaml.hpp"

#include <stdexcept>

namespace castaway::testbed {
namespace {

using localization::AmclConfig;
using localization::AmclSensorModel;

constexpr NumberRange kWeight{0.0, 1.0};
constexpr double kMostParticles = 200000;

void sensor_fields(Settings& settings, AmclConfig& config) {
  localization::LikelihoodFieldConfig& field = config.sensor;
  localization::BeamModelConfig& beam = config.beam;
  settings.choice({"laser_model_type", "", "Sensor model."}, config.model,
                  {{"likelihood_field", AmclSensorModel::kLikelihoodField},
                   {"likelihood_field_prob", AmclSensorModel::kLikelihoodFieldProb},
                   {"beam", AmclSensorModel::kBeam}});
  settings.field({"z_hit", "", "Weight of hits.", kWeight}, field.z_hit);
  settings.field({"z_rand", "", "Weight of random returns.", kWeight}, field.z_rand);
  settings.field({"sigma_hit", "m", "Standard deviation of hits.", {1e-3, 100.0}}, field.sigma_hit);
  beam.z_hit = field.z_hit;
  beam.z_rand = field.z_rand;
  beam.sigma_hit = field.sigma_hit;
  settings.field({"z_short", "", "beam: weight of short returns.", kWeight}, beam.z_short);
  settings.field({"z_max", "", "beam: weight of beams without a return.", kWeight}, beam.z_max);
  settings.field({"lambda_short", "1/m", "beam: decay of short returns.", {1e-6, 1e3}},
                 beam.lambda_short);
  settings.field(
      {"laser_likelihood_max_dist", "m", "Upper bound of the distance field.", {0.01, 1000.0}},
      field.max_distance);
  settings.field({"max_beams", "", "Maximum number of beams used per scan.", {1.0, 1e5}},
                 config.max_beams);
  settings.field({"laser_max_range", "m", "Longer returns are ignored.", {0.01, 1e4}},
                 config.max_range);
}

void motion_fields(Settings& settings, localization::DifferentialMotionConfig& motion) {
  constexpr NumberRange kAlpha{0.0, 100.0};
  settings.field({"alpha1", "", "Noise of rotation from rotation.", kAlpha}, motion.alpha1);
  settings.field({"alpha2", "", "Noise of rotation from translation.", kAlpha}, motion.alpha2);
  settings.field({"alpha3", "", "Noise of translation from translation.", kAlpha}, motion.alpha3);
  settings.field({"alpha4", "", "Noise of translation from rotation.", kAlpha}, motion.alpha4);
}

void filter_fields(Settings& settings, AmclConfig& config) {
  localization::KldConfig& kld = config.kld;
  settings.field({"min_particles", "", "Minimum number of particles.", {1.0, kMostParticles}},
                 kld.min_particles);
  settings.field({"max_particles", "", "Maximum number of particles.", {1.0, kMostParticles}},
                 kld.max_particles);
  settings.field({"pf_err", "", "Bound of the Kullback-Leibler distance.", {1e-4, 1.0}}, kld.error);
  settings.field({"pf_z", "", "Quantile of the normal distribution.", {0.0, 100.0}}, kld.z);
  settings.field({"bin_m", "m", "Edge of a bin in x and y.", {0.01, 10.0}}, kld.bin_m);
  settings.field({"bin_rad", "rad", "Edge of a bin in yaw.", {0.01, 3.2}}, kld.bin_rad);
  settings.field({"recovery_alpha_slow", "", "Rate of the slow average.", kWeight},
                 config.recovery.alpha_slow);
  settings.field({"recovery_alpha_fast", "", "Rate of the fast average.", kWeight},
                 config.recovery.alpha_fast);
  settings.field({"initial_sigma_m",
                  "m",
                  "Standard deviation of a start whose covariance is 0.",
                  {0.0, 100.0}},
                 config.initial.sigma_m);
  settings.field(
      {"initial_sigma_yaw", "rad", "Standard deviation of the yaw of such a start.", {0.0, 100.0}},
      config.initial.sigma_yaw);
}

void beam_skip_fields(Settings& settings, localization::BeamSkipConfig& skip) {
  settings.field(
      {"do_beamskip", "", "likelihood_field_prob: skips beams that few particles explain."},
      skip.enabled);
  settings.field({"beam_skip_distance",
                  "m",
                  "A beam that ends within this distance of a wall is explained.",
                  {0.0, 1000.0}},
                 skip.distance);
  settings.field({"beam_skip_threshold", "",
                  "A beam explained by a smaller share of the particles is skipped.", kWeight},
                 skip.threshold);
  settings.field({"beam_skip_error_threshold", "",
                  "If a larger share of the beams would be skipped, none is.", kWeight},
                 skip.error_threshold);
}

}  // namespace

void fields(Settings settings, AmclConfig& config) {
  motion_fields(settings, config.motion);
  sensor_fields(settings, config);
  filter_fields(settings, config);
  beam_skip_fields(settings, config.beam_skip);
  settings.field(
      {"update_min_d", "m", "Minimum motion along x or y between two updates.", {0.0, 1000.0}},
      config.update_min_d);
  settings.field({"update_min_a", "rad", "Minimum rotation between two updates.", {0.0, 100.0}},
                 config.update_min_a);
  settings.field({"update_at_rest", "", "Updates at every scan, even without motion."},
                 config.update_at_rest);
  settings.field({"half_cell_shift", "", "Shifts the map by half a cell, as Nav2 does."},
                 config.half_cell_shift);
}

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
  fields(Settings::reading(body), config);
  try {
    validate(config);
  } catch (const std::invalid_argument& error) {
    body.fail(error.what());
  }
  return config;
}

}  // namespace castaway::testbed
