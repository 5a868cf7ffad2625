#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {
namespace {

constexpr NumberRange kPopulation{1.0, 20000.0};  // A localizer may have a dozen populations.

}  // namespace

void fields(Settings settings, localization::EndpointConfig& endpoint) {
  settings.field({"sigma", "m", "Standard deviation of end points around walls.", {1e-6, 1e4}},
                 endpoint.sigma);
  settings.field(
      {"floor", "", "Likelihood far from all walls, relative to the likelihood at a wall.", kShare},
      endpoint.floor);
  settings.field(
      {"independent_beams", "", "Number of independent beams that a scan counts as.", {0.0, 1e5}},
      endpoint.independent_beams);
}

void fields(Settings settings, localization::RayConsistencyConfig& rays) {
  settings.field(
      {"margin", "m", "Walls within this distance in front of the end point are ignored.", kLength},
      rays.margin);
  settings.field({"margin_share", "",
                  "The same distance as a share of the range; the larger one applies.", kShare},
                 rays.margin_share);
}

void fields(Settings settings, localization::RefineConfig& refine) {
  settings.field({"step_m", "m", "First step.", kLength}, refine.step_m);
  settings.field({"step_rad", "rad", "First step.", kAngle}, refine.step_rad);
  settings.field({"halvings", "", "Number of times that the steps are halved.", {0.0, 30.0}},
                 refine.halvings);
}

void fields(Settings settings, localization::SpawnConfig& spawn) {
  settings.field({"sigma", "m", "Minimum spread of a new population.", kLength}, spawn.sigma);
  settings.field({"sigma_yaw", "rad", "Minimum yaw spread of a new population.", kAngle},
                 spawn.sigma_yaw);
}

void fields(Settings settings, localization::MergeConfig& merge) {
  settings.field({"distance", "m", "Poses closer than this are the same place.", kLength},
                 merge.distance);
  settings.field(
      {"yaw", "rad", "Poses whose yaw differs by less than this are the same place.", kAngle},
      merge.yaw);
}

void reseed_fields(Settings& settings, localization::ReseedConfig& reseed) {
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
  settings.field({"ridge_steps",
                  "",
                  "A winner is averaged over so many poses to either side along its least certain "
                  "direction, half a standard deviation apart; 0: it is the peak.",
                  {0.0, 1000.0}},
                 reseed.ridge_steps);
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
