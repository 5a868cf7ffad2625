#include "tools/scenario/localizers/mh_amcl_fields.hpp"

#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {
namespace {

using localization::ByteFieldConfig;
using localization::CreateConfig;
using localization::DestroyConfig;
using localization::LostAndFoundConfig;
using localization::MatchAlgorithm;
using localization::MatcherConfig;
using localization::MatchScheduleConfig;
using localization::MhAmclConfig;
using localization::PosteriorConfig;
using localization::RescueConfig;
using localization::ScanAgreementConfig;

void fields(Settings settings, ByteFieldConfig& field) {
  settings.field({"resolution", "m", "Cell size of the coarse search.", kLength}, field.resolution);
  settings.field({"sigma", "m", "Standard deviation of end points around walls.", kLength},
                 field.sigma);
  settings.field({"padding", "m", "Width of the border of zeros around the map.", kLength},
                 field.padding);
}

void fields(Settings settings, MatcherConfig& matcher) {
  fields(settings.group("field"), matcher.field);
  settings.field({"yaw_step", "rad", "Step of the yaw.", kAngle}, matcher.yaw_step);
  settings.field({"points", "", "End points used, evenly over the scan.", {1.0, 256.0}},
                 matcher.points);
  settings.field({"candidates", "", "Maximum number of places returned.", kCount},
                 matcher.candidates);
  settings.field(
      {"suppression_m", "m", "Only the best place of a square of this size is kept.", kLength},
      matcher.suppression_m);
  settings.field({"suppression_rad", "rad",
                  "Only the best place of a yaw interval of this size is kept.", kAngle},
                 matcher.suppression_rad);
  settings.choice({"algorithm", "", "Search algorithm; both find the same places."},
                  matcher.algorithm,
                  {{"branch_and_bound", MatchAlgorithm::kBranchAndBound},
                   {"exhaustive", MatchAlgorithm::kExhaustive}});
  settings.field({"levels", "", "Number of levels of the branch and bound pyramid.", {1.0, 8.0}},
                 matcher.levels);
}

void fields(Settings settings, MatchScheduleConfig& match) {
  int slice = static_cast<int>(match.slice);
  settings.field({"slice", "", "Number of tiles searched per scan.", {1.0, 1e9}}, slice);
  match.slice = slice;
  settings.field(
      {"at_once", "", "Number of searches with consecutive scans after an alarm.", {0.0, 1000.0}},
      match.at_once);
  settings.field({"moved_m", "m", "After that, minimum motion since the last search.", kLength},
                 match.moved_m);
  settings.field({"turned_rad", "rad",
                  "After that, alternatively minimum rotation since the last search.", kAngle},
                 match.turned_rad);
  settings.field(
      {"patience_s", "s", "After that, alternatively minimum time since the last search.", kTime},
      match.patience_s);
  settings.field({"first_pause_s", "s",
                  "Pause after a search that found nothing new; doubles each time.", kTime},
                 match.first_pause_s);
  settings.field({"longest_pause_s", "s", "Longest pause.", kTime}, match.longest_pause_s);
}

void fields(Settings settings, RescueConfig& rescue) {
  settings.field(
      {"drop", "nats",
       "A rescue starts if the scan at the output is less likely than usual by this.", kNats},
      rescue.drop);
  settings.field({"radius", "m", "Position range of the search around the output.", kLength},
                 rescue.radius);
  settings.field({"yaw_radius", "rad", "Yaw range of the search around the output.", kAngle},
                 rescue.yaw_radius);
  settings.field({"candidates", "", "Maximum number of candidates that are refined.", kCount},
                 rescue.candidates);
  settings.field({"gain", "nats", "Minimum improvement by the place found.", kNats}, rescue.gain);
  settings.field(
      {"cost", "nats", "The place found starts with the output's weight minus this.", kNats},
      rescue.cost);
}

void fields(Settings settings, CreateConfig& create) {
  settings.field({"far_share", "",
                  "The map is searched again with this share of the end points, the farthest ones; "
                  "0: not again.",
                  kShare},
                 create.far_share);
  settings.field(
      {"deep_below", "nats", "If the best place scores less, a deep search follows.", kNats},
      create.deep_below);
  settings.field({"deep_candidates", "", "Number of places of a deep search.", kCount},
                 create.deep_candidates);
  settings.field({"looked_at", "", "Number of candidates whose evidence is computed.", kCount},
                 create.looked_at);
  settings.field({"refined", "", "Number of candidates that are refined.", kCount}, create.refined);
  settings.field({"keep", "", "Number of candidates that are weighted by older scans.", kCount},
                 create.keep);
  fields(settings.group("refine"), create.refine);
  fields(settings.group("refine_back"), create.refine_back);
}

void fields(Settings settings, DestroyConfig& destroy) {
  settings.field(
      {"behind", "nats", "Populations that are further behind the best one are removed.", kNats},
      destroy.behind);
  settings.field({"most_confident",
                  "",
                  "Maximum number of populations while one is confident.",
                  {1.0, 1000.0}},
                 destroy.most_confident);
  settings.field(
      {"most", "", "Maximum number of populations while the place is ambiguous.", {1.0, 1000.0}},
      destroy.most);
}

void fields(Settings settings, ScanAgreementConfig& agreement) {
  settings.field({"tolerance", "m", "Ranges agree within this distance.", kLength},
                 agreement.tolerance);
  settings.field(
      {"tolerance_share", "", "Share of the range that is added to the tolerance.", kShare},
      agreement.tolerance_share);
  settings.field(
      {"widest_gap", "rad", "Beams that are further apart are not interpolated.", kAngle},
      agreement.widest_gap);
  settings.field({"least", "", "Minimum number of comparable points.", {1.0, 1e5}},
                 agreement.least);
}

void unlisted_fields(Settings& settings, PosteriorConfig& p) {
  settings.field({"unlisted_drop", "nats",
                  "Log-likelihood of an unlisted place relative to a usual right one.", kNats},
                 p.null.unlisted_drop);
  settings.field({"least_drop", "nats", "Minimum of this difference.", kNats}, p.null.least_drop);
  settings.field({"drop_per_spread",
                  "",
                  "The difference per spread of the likelihood of right places.",
                  {0.0, 100.0}},
                 p.null.drop_per_spread);
  settings.field(
      {"unlisted_minimum", "nats", "Minimum log-likelihood of an unlisted place.", kNats},
      p.null.unlisted_minimum);
  settings.field({"place", "nats", "Log-probability of one place among all unlisted ones.", kNats},
                 p.place);
  settings.field(
      {"wrong_start", "nats", "Log-probability that a given start pose is wrong.", kNats},
      p.null.wrong_start);
  settings.field({"missed", "nats", "Log-odds that a search misses the right place.", kNats},
                 p.null.missed);
  settings.field({"missed_slope",
                  "",
                  "Growth of these log-odds per nat that the best place fits worse.",
                  {0.0, 100.0}},
                 p.null.missed_slope);
}

void kidnap_fields(Settings& settings, PosteriorConfig& p) {
  settings.field({"kidnap", "nats", "Log-probability of a kidnap from scan to scan.", kNats},
                 p.null.kidnap);
  settings.field({"agreeing", "",
                  "Consecutive scans that agree better are evidence against a kidnap.", kShare},
                 p.scans.agreeing);
  settings.field(
      {"agreeing_slope", "nats", "Strength of this evidence per unit of agreement.", kNats},
      p.scans.agreeing_slope);
  settings.field({"agreeing_at_rest", "nats", "Reduction of this evidence at rest.", kNats},
                 p.scans.agreeing_at_rest);
  settings.field(
      {"disagreeing", "", "Consecutive scans that agree worse are evidence for a kidnap.", kShare},
      p.scans.disagreeing);
  settings.field(
      {"disagreeing_slope", "nats", "Strength of this evidence per unit of agreement.", kNats},
      p.scans.disagreeing_slope);
  settings.field(
      {"hopeless", "nats",
       "If the scan at the output is less likely, a kidnap is at least as likely as none.", kNats},
      p.null.hopeless);
}

void fields(Settings settings, PosteriorConfig& p) {
  settings.field({"independent_m", "m", "Distance after which a scan is independent.", kLength},
                 p.scans.independent_m);
  settings.field({"independent_rad", "rad", "Rotation after which a scan is independent.", kAngle},
                 p.scans.independent_rad);
  settings.field({"least_independence", "", "Independent share of a scan at rest.", kShare},
                 p.scans.least_independence);
  unlisted_fields(settings, p);
  kidnap_fields(settings, p);
  settings.field(
      {"usual_start", "nats", "Initial log-likelihood of a right pose; it is then learnt.", kNats},
      p.null.usual_start);
  settings.field({"usual_match_rate", "",
                  "Weight in the running average of a search that finds nothing as good.", kShare},
                 p.null.usual_match_rate);
  settings.field({"usual_rate", "", "Weight of a confident scan in the running average.", kShare},
                 p.null.usual_rate);
  settings.field(
      {"spread_rate", "", "Weight of a scan in the running average of the spread.", kShare},
      p.null.spread_rate);
  settings.field({"spread_limit",
                  "",
                  "Maximum deviation of one scan, as a multiple of the spread.",
                  {0.0, 100.0}},
                 p.null.spread_limit);
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

void evidence_fields(Settings& settings, MhAmclConfig& config) {
  Settings evidence = settings.group("evidence");
  fields(settings.group("tracking"), config.tracking);
  fields(evidence.group("endpoint"), config.evidence.endpoint);
  fields(evidence.group("rays"), config.evidence.rays);
  evidence.field({"through_wall", "", "Likelihood of a beam through a mapped wall.", kShare},
                 config.evidence.through_wall);
  evidence.field({"off_free_penalty", "nats", "Penalty if base is not on a free cell.", kNats},
                 config.evidence.off_free_penalty);
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
  evidence_fields(settings, config);
  fields(settings.group("refine"), config.refine);
  fields(settings.group("spawn"), config.spawn);
  fields(settings.group("merge"), config.merge);
  fields(settings.group("matcher"), config.matcher);
  fields(settings.group("match"), config.match);
  fields(settings.group("rescue"), config.rescue);
  fields(settings.group("create"), config.create);
  fields(settings.group("destroy"), config.destroy);
  fields(settings.group("agreement"), config.agreement);
  fields(settings.group("posterior"), config.posterior);
  fields(settings.group("lost_and_found"), config.lost_and_found);
}

}  // namespace castaway::testbed
