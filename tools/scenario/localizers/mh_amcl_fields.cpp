#include "tools/scenario/localizers/mh_amcl_fields.hpp"

#include "tools/scenario/localizers/posterior_fields.hpp"
#include "tools/scenario/localizers/search_fields.hpp"

namespace castaway::testbed {
namespace {

using localization::DestroyConfig;
using localization::LostAndFoundConfig;
using localization::MhAmclConfig;

void fields(Settings settings, DestroyConfig& destroy) {
  settings.field(
      {"behind", "nats", "Populations that are further behind the best one are removed.", kNats},
      destroy.behind);
  settings.field({"behind_confident", "nats", "The same while one is confident.", kNats},
                 destroy.behind_confident);
  settings.field({"most_confident",
                  "",
                  "Maximum number of populations while one is confident.",
                  {1.0, 1000.0}},
                 destroy.most_confident);
  settings.field(
      {"most", "", "Maximum number of populations while the place is ambiguous.", {1.0, 1000.0}},
      destroy.most);
}

void fields(Settings settings, LostAndFoundConfig& lost) {
  settings.field(
      {"unexplained_cue", "nats",
       "Without a kidnap cue above this, an output that jumps must be confirmed by driving.",
       kNats},
      lost.unexplained_cue);
  settings.field({"proving_m", "m", "Distance driven until such an output is confirmed.", kLength},
                 lost.proving_m);
}

void fields(Settings settings, localization::DistanceFilterConfig& filter) {
  settings.field(
      {"before_wall", "m", "Beams that end by more than this before a wall do not track.", kLength},
      filter.before_wall);
  settings.field(
      {"misfits", "", "Minimum share of end points off the walls to leave beams out.", kShare},
      filter.misfits);
  settings.field({"off_wall", "m", "An end point farther from all walls is off them.", kLength},
                 filter.off_wall);
  settings.field({"least", "", "With fewer beams left, all of them track.", kCount}, filter.least);
}

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
  Settings mixture = settings.group("mixture");
  mixture.field(
      {"widest", "m", "A wider component of a new mixture is divided in three.", {1e-3, 1e4}},
      config.mixture.widest);
  mixture.field({"widest_yaw", "rad", "The same of the yaw.", {1e-3, 100.0}},
                config.mixture.widest_yaw);
  mixture.field({"most", "", "Maximum number of components.", {1.0, 1000.0}}, config.mixture.most);
  mixture.field(
      {"lightest", "", "Components with a smaller share of the weight are dropped.", kShare},
      config.mixture.lightest);
  mixture.field(
      {"same", "", "Components with a smaller Mahalanobis distance become one.", {0.0, 100.0}},
      config.mixture.same);
  Settings ndt = settings.group("ndt");
  ndt.field({"cell", "m", "Edge of a cell of the normal distributions transform.", {0.05, 10.0}},
            config.ndt.cell);
  ndt.field({"along", "", "Factor of its standard deviations along surfaces.", {1.0, 100.0}},
            config.ndt.along);
}

void evidence_fields(Settings& settings, MhAmclConfig& config) {
  Settings evidence = settings.group("evidence");
  fields(settings.group("tracking"), config.tracking);
  fields(settings.group("refinement"), config.refinement);
  fields(settings.group("distance_filter"), config.distance_filter);
  fields(evidence.group("endpoint"), config.evidence.endpoint);
  fields(evidence.group("rays"), config.evidence.rays);
  evidence.field({"through_wall", "", "Likelihood of a beam through a mapped wall.", kShare},
                 config.evidence.through_wall);
  evidence.field({"off_free_penalty", "nats", "Penalty if base is not on a free cell.", kNats},
                 config.evidence.off_free_penalty);
  evidence.field({"per_beam",
                  "",
                  "A beam counts as at most this many independent ones: few beams say little.",
                  {0.001, 1000.0}},
                 config.evidence.per_beam);
  evidence.field(
      {"right_pose", "nats", "Log-likelihood of a scan at a right pose; subtracted.", kNats},
      config.evidence.right_pose);
  evidence.field({"minimum", "nats", "Minimum log-likelihood of a scan.", kNats},
                 config.evidence.minimum);
}

}  // namespace

void fields(Settings settings, MhAmclConfig& config) {
  rate_fields(settings, config);
  reseed_fields(settings, config.reseed);
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
  settings.field({"budget_ms",
                  "ms",
                  "CPU time of a scan in the mean, on a processor that scores 8000 tiles in a "
                  "millisecond; less finds places later.",
                  {0.01, 1e6}},
                 config.budget.mean_ms);
  settings.field({"budget_most_ms", "ms", "The same of one scan at most.", {0.01, 1e6}},
                 config.budget.most_ms);
  settings.field({"select_margin",
                  "nats",
                  "The output is kept while it is behind the best one by less than this.",
                  {0.0, 1e6}},
                 config.select_margin);
  settings.field(
      {"history", "", "Number of scans by which a new population is weighted.", {1.0, 1000.0}},
      config.history);
  settings.field({"max_distance", "m", "Upper bound of the distance field.", {0.01, 1000.0}},
                 config.max_distance);
  settings.field({"surface_depth",
                  "m",
                  "No beam ends deeper inside of an obstacle of the map.",
                  {0.0, 1000.0}},
                 config.surface_depth);
  belief_fields(settings, config);
  evidence_fields(settings, config);
  fields(settings.group("refine"), config.refine);
  fields(settings.group("spawn"), config.spawn);
  fields(settings.group("merge"), config.merge);
  fields(settings.group("same"), config.same);
  fields(settings.group("matcher"), config.matcher);
  fields(settings.group("match"), config.match);
  fields(settings.group("watch"), config.watch);
  fields(settings.group("rescue"), config.rescue);
  fields(settings.group("create"), config.create);
  fields(settings.group("destroy"), config.destroy);
  fields(settings.group("agreement"), config.agreement);
  fields(settings.group("continuity"), config.continuity);
  fields(settings.group("posterior"), config.posterior);
  fields(settings.group("lost_and_found"), config.lost_and_found);
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
  fields(settings, config.mh_amcl);
}

}  // namespace castaway::testbed
