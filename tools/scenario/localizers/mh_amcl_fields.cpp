#include "tools/scenario/localizers/mh_amcl_fields.hpp"

#include <utility>

#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {
namespace {

using localization::MhAmclConfig;

/// What populations are, and how poses are refined.
void belief_fields(Settings& settings, MhAmclConfig& config) {
  settings.choice(
      {"belief", "", "What a population is: particles, or a mixture of normal distributions."},
      config.belief,
      {{"particles", localization::BeliefKind::kParticles},
       {"gaussians", localization::BeliefKind::kGaussians}});
  settings.choice({"refine_by", "",
                   "How poses are refined on a scan: by hill climbing on distances to surfaces, or "
                   "by registration with a normal distributions transform of the map: of points, "
                   "or of distributions."},
                  config.refine_by,
                  {{"climb", localization::RefineMethod::kClimb},
                   {"ndt_points", localization::RefineMethod::kNdtPoints},
                   {"ndt_distributions", localization::RefineMethod::kNdtDistributions}});
}

/// When an output is lost, found or confident.
void output_fields(Settings& settings, MhAmclConfig& config) {
  settings.field({"confident", "", "Minimum probability of a confident output."},
                 config.match.confident);
  settings.field({"found", "", "Minimum probability at which a lost output counts as found."},
                 config.lost_and_found.found);
  settings.field({"stays", "", "Minimum probability at which a found output stays found."},
                 config.lost_and_found.stays);
  settings.field({"blind_half_life", "s",
                  "While the lidar sees nothing, the stated probability halves in this time; 0: it "
                  "stays.",
                  kTime},
                 config.blind_half_life);
  settings.field({"select_margin",
                  "nats",
                  "The output is kept while it is behind the best one by less than this.",
                  {0.0, 1e6}},
                 config.select_margin);
}

void sensor_fields(Settings& settings, MhAmclConfig& config) {
  constexpr NumberRange kSigma{1e-6, 1e4};
  settings.group("tracking")
      .field(
          {"sigma", "m", "Standard deviation of end points around walls, for particles.", kSigma},
          config.tracking.sigma);
  Settings endpoint = settings.group("evidence").group("endpoint");
  endpoint.field(
      {"sigma", "m", "Standard deviation of end points around walls, for hypotheses.", kSigma},
      config.evidence.endpoint.sigma);
  endpoint.field(
      {"independent_beams", "", "Number of independent beams that a scan counts as.", {0.0, 1e5}},
      config.evidence.endpoint.independent_beams);
}

void tiles_field(Settings settings, const char* key, const char* meaning, std::int64_t& tiles) {
  int count = static_cast<int>(tiles);
  settings.field({key, "", meaning, {1.0, 1e9}}, count);
  tiles = count;
}

/// How much is searched, and when.
void search_fields(Settings& settings, MhAmclConfig& config) {
  settings.field({"budget_ms",
                  "ms",
                  "CPU time of a scan in the mean, on a processor that scores 8000 tiles in a "
                  "millisecond; less finds places later.",
                  {0.01, 1e6}},
                 config.budget.mean_ms);
  settings.field({"budget_most_ms", "ms", "The same of one scan at most.", {0.01, 1e6}},
                 config.budget.most_ms);
  tiles_field(settings.group("match"), "slice", "Number of tiles searched per scan.",
              config.match.slice);
  Settings watch = settings.group("watch");
  tiles_field(watch, "slice", "Number of tiles searched per period in the background.",
              config.watch.slice);
  tiles_field(watch, "burst", "Number of tiles searched per period on suspicion.",
              config.watch.burst);
  watch.field(
      {"suspicious_cue", "nats", "Evidence for a kidnap in a scan that is suspicious.", kNats},
      config.watch.suspicious_cue);
  watch.field({"suspicious_doubt", "nats", "Doubt that is suspicious.", kNats},
              config.watch.suspicious_doubt);
  Settings create = settings.group("create");
  create.field({"quick_candidates", "", "Number of places of the first search.", kCount},
               config.create.quick_candidates);
  create.field({"deep_candidates", "", "Maximum number of places of a deep search.", kCount},
               config.create.deep_candidates);
  create.field({"settled_beams",
                "",
                "Beams on which candidates climb before their evidence is computed; 0: none.",
                {0, 100000}},
               config.create.settled_beams);
}

/// What is known before a scan: kidnaps, and how much a scan says.
void prior_fields(Settings& settings, localization::PosteriorConfig& prior) {
  settings.field(
      {"independent_m", "m", "Distance after which a scan is independent evidence.", kLength},
      prior.scans.independent_m);
  settings.field({"unlisted_drop", "nats",
                  "Log-likelihood of an unlisted place relative to a usual right one.", kNats},
                 prior.null.unlisted_drop);
  settings.field(
      {"wrong_start", "nats", "Log-probability that a given start pose is wrong.", kNats},
      prior.null.wrong_start);
  settings.field({"kidnap", "nats", "Log-probability of a kidnap from scan to scan.", kNats},
                 prior.null.kidnap);
  settings.field({"agreeing", "",
                  "Consecutive scans that agree better are evidence against a kidnap.", kShare},
                 prior.scans.agreeing);
  settings.field(
      {"false_alarms_per_h",
       "",
       "Tolerated number of false alarms in an hour; sets the doubt that raises an alarm.",
       {1e-6, 14400.0}},
      prior.null.false_alarms_per_h);
}

}  // namespace

void fields(Settings settings, MhAmclConfig& config) {
  rate_fields(settings, config);
  size_fields(settings, config.reseed);
  output_fields(settings, config);
  belief_fields(settings, config);
  sensor_fields(settings, config);
  search_fields(settings, config);
  Settings posterior = settings.group("posterior");
  prior_fields(posterior, config.posterior);
}

void map3d_fields(Settings settings, localization::MhAmcl3dConfig& config) {
  settings.field({"voxel", "m", "Edge of a voxel of the 3-D map.", {0.02, 1.0}}, config.voxel);
  settings.choice({"track_by", "",
                   "By what particles are weighed: the distance of a beam's end from the nearest "
                   "surface, or the same along the beam, as in the paper."},
                  config.mh_amcl.track_by,
                  {{"distance", localization::TrackingError::kDistance},
                   {"along_beam", localization::TrackingError::kAlongBeam}});
}

void fields(Settings settings, localization::MhAmcl3dConfig& config) {
  map3d_fields(settings, config);
  fields(std::move(settings), config.mh_amcl);
}

}  // namespace castaway::testbed
