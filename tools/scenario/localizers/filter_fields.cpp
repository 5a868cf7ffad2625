#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {
namespace {

constexpr NumberRange kPopulation{1.0, 20000.0};  // A localizer may have a dozen populations.

}  // namespace

void size_fields(Settings& settings, localization::ReseedConfig& reseed) {
  settings.field({"min_particles", "", "Particles of a population without spread.", kPopulation},
                 reseed.min_particles);
  settings.field({"max_particles", "",
                  "Particles of a population with a spread of at least wide_spread.", kPopulation},
                 reseed.max_particles);
  settings.field(
      {"wide_spread", "m", "Standard deviation at which max_particles are used.", {1e-6, 1e4}},
      reseed.wide_spread);
  settings.field({"effective_share", "",
                  "A smaller effective share of the particles triggers reseeding.", kShare},
                 reseed.effective_share);
}

void beam_fields(Settings& settings, localization::BeamSelection& beams) {
  settings.field({"max_beams", "", "Maximum number of beams used per scan.", {1.0, 1e5}},
                 beams.max_beams);
  settings.field({"max_range", "m", "Longer returns are ignored.", {0.01, 1e4}}, beams.max_range);
  settings.field({"max_tilted",
                  "",
                  "mode 3d: maximum number of beams of a 3-D lidar's other layers that end on what "
                  "is steep.",
                  {0.0, 1e5}},
                 beams.max_tilted);
  settings.field({"max_flat",
                  "",
                  "mode 3d: maximum number of beams of a 3-D lidar that end on ground or ceilings.",
                  {0.0, 1e5}},
                 beams.max_flat);
}

void motion_fields(Settings& settings, localization::OdometryNoiseConfig& motion) {
  constexpr NumberRange kNoise{0.0, 100.0};
  settings.field(
      {"trans_per_m", "m/sqrt(m)", "Standard deviation of the position after one metre.", kNoise},
      motion.trans_per_m);
  settings.field({"trans_per_rad", "m/sqrt(rad)",
                  "Standard deviation of the position after one radian.", kNoise},
                 motion.trans_per_rad);
  settings.field(
      {"rot_per_m", "rad/sqrt(m)", "Standard deviation of the yaw after one metre.", kNoise},
      motion.rot_per_m);
  settings.field(
      {"rot_per_rad", "rad/sqrt(rad)", "Standard deviation of the yaw after one radian.", kNoise},
      motion.rot_per_rad);
}

}  // namespace castaway::testbed
