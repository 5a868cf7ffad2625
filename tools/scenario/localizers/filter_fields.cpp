#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {
namespace {

constexpr NumberRange kPopulation{1.0, 20000.0};  // A localizer may have a dozen populations.

}  // namespace

void fields(Settings settings, localization::EndpointConfig& endpoint) {
  settings.field({"sigma", "m", "Spread of end points about walls.", {1e-6, 1e4}}, endpoint.sigma);
  settings.field({"floor", "", "Likelihood far from any wall, relative to one on a wall.", kShare},
                 endpoint.floor);
  settings.field({"independent_beams", "", "The scan counts as so many beams.", {0.0, 1e5}},
                 endpoint.independent_beams);
}

void fields(Settings settings, localization::RayConsistencyConfig& rays) {
  settings.field({"margin", "m", "Walls so close before the end point do not count.", kLength},
                 rays.margin);
  settings.field({"margin_share", "", "The same as a share of the range.", kShare},
                 rays.margin_share);
}

void fields(Settings settings, localization::RefineConfig& refine) {
  settings.field({"step_m", "m", "First step.", kLength}, refine.step_m);
  settings.field({"step_rad", "rad", "First step.", kAngle}, refine.step_rad);
  settings.field({"halvings", "", "How often the steps are halved.", {0.0, 30.0}}, refine.halvings);
}

void fields(Settings settings, localization::SpawnConfig& spawn) {
  settings.field({"sigma", "m", "Least spread of a new population.", kLength}, spawn.sigma);
  settings.field({"sigma_yaw", "rad", "Least spread of its yaw.", kAngle}, spawn.sigma_yaw);
}

void fields(Settings settings, localization::MergeConfig& merge) {
  settings.field({"distance", "m", "Poses closer than this are one place.", kLength},
                 merge.distance);
  settings.field({"yaw", "rad", "Poses turned less than this are one place.", kAngle}, merge.yaw);
}

void reseed_fields(Settings& settings, localization::ReseedConfig& reseed) {
  settings.field({"min_particles", "", "Of a population that is sure of its place.", kPopulation},
                 reseed.min_particles);
  settings.field({"max_particles", "", "Of a population that is spread.", kPopulation},
                 reseed.max_particles);
  settings.field(
      {"wide_spread", "m", "Standard deviation at which max_particles are used.", {1e-6, 1e4}},
      reseed.wide_spread);
  settings.field({"effective_share", "", "Reseeds where fewer particles carry the weight.", kShare},
                 reseed.effective_share);
}

void beam_fields(Settings& settings, localization::BeamSelection& beams) {
  settings.field({"max_beams", "", "Beams used of a scan.", {1.0, 1e5}}, beams.max_beams);
  settings.field({"max_range", "m", "Longer returns are ignored.", {0.01, 1e4}}, beams.max_range);
}

void motion_fields(Settings& settings, localization::OdometryNoiseConfig& motion) {
  constexpr NumberRange kNoise{0.0, 100.0};
  settings.field({"trans_per_m", "m/sqrt(m)", "Spread of the position after a metre.", kNoise},
                 motion.trans_per_m);
  settings.field({"trans_per_rad", "m/sqrt(rad)", "Spread of the position after a radian.", kNoise},
                 motion.trans_per_rad);
  settings.field({"rot_per_m", "rad/sqrt(m)", "Spread of the yaw after a metre.", kNoise},
                 motion.rot_per_m);
  settings.field({"rot_per_rad", "rad/sqrt(rad)", "Spread of the yaw after a radian.", kNoise},
                 motion.rot_per_rad);
}

}  // namespace castaway::testbed
