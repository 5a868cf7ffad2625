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
  settings.field({"resolution", "m", "Coarse cell of the search.", kLength}, field.resolution);
  settings.field({"sigma", "m", "Spread of end points about walls.", kLength}, field.sigma);
  settings.field({"padding", "m", "Border of zeros about the map.", kLength}, field.padding);
}

void fields(Settings settings, MatcherConfig& matcher) {
  fields(settings.group("field"), matcher.field);
  settings.field({"yaw_step", "rad", "Step of the yaw.", kAngle}, matcher.yaw_step);
  settings.field({"points", "", "End points used, evenly over the scan.", {1.0, 256.0}},
                 matcher.points);
  settings.field({"candidates", "", "Places returned at most.", kCount}, matcher.candidates);
  settings.field(
      {"suppression_m", "m", "Of a square so large only the best place is kept.", kLength},
      matcher.suppression_m);
  settings.field(
      {"suppression_rad", "rad", "Of a range of yaws so wide only the best is kept.", kAngle},
      matcher.suppression_rad);
  settings.choice({"algorithm", "", "Both find the same places."}, matcher.algorithm,
                  {{"branch_and_bound", MatchAlgorithm::kBranchAndBound},
                   {"exhaustive", MatchAlgorithm::kExhaustive}});
  settings.field({"levels", "", "Of the pyramid of branch and bound.", {1.0, 8.0}}, matcher.levels);
}

void fields(Settings settings, MatchScheduleConfig& match) {
  int slice = static_cast<int>(match.slice);
  settings.field({"slice", "", "Tiles searched with one scan.", {1.0, 1e9}}, slice);
  match.slice = slice;
  settings.field({"at_once", "", "Searches scan by scan after an alarm.", {0.0, 1000.0}},
                 match.at_once);
  settings.field({"moved_m", "m", "Then a search needs so much way...", kLength}, match.moved_m);
  settings.field({"turned_rad", "rad", "...or turn...", kAngle}, match.turned_rad);
  settings.field({"patience_s", "s", "...or time since the last one.", kTime}, match.patience_s);
  settings.field(
      {"first_pause_s", "s", "Pause after a search that found nothing new; doubles.", kTime},
      match.first_pause_s);
  settings.field({"longest_pause_s", "s", "Longest pause.", kTime}, match.longest_pause_s);
}

void fields(Settings settings, RescueConfig& rescue) {
  settings.field({"drop", "nats", "The output's scan is so much less likely than usual.", kNats},
                 rescue.drop);
  settings.field({"radius", "m", "Searched about the output.", kLength}, rescue.radius);
  settings.field({"yaw_radius", "rad", "Searched about the output.", kAngle}, rescue.yaw_radius);
  settings.field({"candidates", "", "Refined at most.", kCount}, rescue.candidates);
  settings.field({"gain", "nats", "A place found must be so much better.", kNats}, rescue.gain);
  settings.field(
      {"cost", "nats", "A place found begins with the output's weight less this.", kNats},
      rescue.cost);
}

void fields(Settings settings, CreateConfig& create) {
  settings.field({"far_share", "",
                  "The map is searched again by the farthest share of the end "
                  "points.",
                  kShare},
                 create.far_share);
  settings.field({"deep_below", "nats",
                  "Where the best place scores less, the map is searched "
                  "deeper.",
                  kNats},
                 create.deep_below);
  settings.field({"deep_candidates", "", "Places of a deep search.", kCount},
                 create.deep_candidates);
  settings.field({"looked_at", "", "Candidates whose evidence is taken.", kCount},
                 create.looked_at);
  settings.field({"refined", "", "Candidates refined.", kCount}, create.refined);
  settings.field({"keep", "", "Candidates weighed on older scans.", kCount}, create.keep);
  fields(settings.group("refine"), create.refine);
  fields(settings.group("refine_back"), create.refine_back);
}

void fields(Settings settings, DestroyConfig& destroy) {
  settings.field({"behind", "nats", "Populations so far behind the best one go.", kNats},
                 destroy.behind);
  settings.field({"most_confident", "", "Kept while one is confident.", {1.0, 1000.0}},
                 destroy.most_confident);
  settings.field({"most", "", "Kept while the place is ambiguous.", {1.0, 1000.0}}, destroy.most);
}

void fields(Settings settings, ScanAgreementConfig& agreement) {
  settings.field({"tolerance", "m", "Ranges so close agree.", kLength}, agreement.tolerance);
  settings.field({"tolerance_share", "", "Added to it: this share of the range.", kShare},
                 agreement.tolerance_share);
  settings.field({"widest_gap", "rad", "Between beams farther apart nothing is known.", kAngle},
                 agreement.widest_gap);
  settings.field({"least", "", "Fewer points that can be compared say nothing.", {1.0, 1e5}},
                 agreement.least);
}

void unlisted_fields(Settings& settings, PosteriorConfig& p) {
  settings.field({"unlisted_drop", "nats",
                  "An unlisted place is worth this much less than a usual "
                  "right one.",
                  kNats},
                 p.unlisted_drop);
  settings.field({"least_drop", "nats", "Least such drop.", kNats}, p.least_drop);
  settings.field({"drop_per_spread", "", "Drop per spread of right places.", {0.0, 100.0}},
                 p.drop_per_spread);
  settings.field({"unlisted_minimum", "nats", "Never less than this in all.", kNats},
                 p.unlisted_minimum);
  settings.field({"place", "nats", "Log-probability of one place among all unlisted ones.", kNats},
                 p.place);
  settings.field({"wrong_start", "nats", "Log-probability that a start given is wrong.", kNats},
                 p.wrong_start);
  settings.field({"missed", "nats", "Log-odds that a search misses the right place.", kNats},
                 p.missed);
  settings.field(
      {"missed_slope", "", "Their growth per nat that the best place fits worse.", {0.0, 100.0}},
      p.missed_slope);
}

void kidnap_fields(Settings& settings, PosteriorConfig& p) {
  settings.field({"kidnap", "nats", "Log-probability of a kidnap from scan to scan.", kNats},
                 p.kidnap);
  settings.field(
      {"agreeing", "", "Scans in a row that agree better speak against a kidnap.", kShare},
      p.agreeing);
  settings.field({"agreeing_slope", "nats", "By so many per unit of agreement.", kNats},
                 p.agreeing_slope);
  settings.field({"agreeing_at_rest", "nats", "Less so many at rest.", kNats}, p.agreeing_at_rest);
  settings.field({"disagreeing", "", "Scans that agree worse speak for a kidnap.", kShare},
                 p.disagreeing);
  settings.field({"disagreeing_slope", "nats", "By so many per unit of agreement.", kNats},
                 p.disagreeing_slope);
  settings.field(
      {"hopeless", "nats", "A scan less likely at the output makes a kidnap likely.", kNats},
      p.hopeless);
}

void fields(Settings settings, PosteriorConfig& p) {
  settings.field({"independent_m", "m", "After so much way a scan is new.", kLength},
                 p.independent_m);
  settings.field({"independent_rad", "rad", "After so much turning a scan is new.", kAngle},
                 p.independent_rad);
  settings.field({"least_independence", "", "New share of a scan at rest.", kShare},
                 p.least_independence);
  unlisted_fields(settings, p);
  kidnap_fields(settings, p);
  settings.field(
      {"usual_start", "nats", "Log-likelihood of a right pose, until it is learnt.", kNats},
      p.usual_start);
  settings.field({"usual_match_rate", "", "Weight of a search that finds nothing so good.", kShare},
                 p.usual_match_rate);
  settings.field({"usual_rate", "", "Weight of a confident scan in the running average.", kShare},
                 p.usual_rate);
  settings.field({"spread_rate", "", "Weight of a scan in the average of the spread.", kShare},
                 p.spread_rate);
  settings.field({"spread_limit", "", "So many spreads count of one scan.", {0.0, 100.0}},
                 p.spread_limit);
}

void fields(Settings settings, LostAndFoundConfig& lost) {
  settings.field({"unexplained_cue", "nats",
                  "Without a kidnap cue above this, an output that "
                  "jumps must prove itself.",
                  kNats},
                 lost.unexplained_cue);
  settings.field({"proving_m", "m", "Way that it takes.", kLength}, lost.proving_m);
}

void evidence_fields(Settings& settings, MhAmclConfig& config) {
  Settings evidence = settings.group("evidence");
  fields(settings.group("tracking"), config.tracking);
  fields(evidence.group("endpoint"), config.evidence.endpoint);
  fields(evidence.group("rays"), config.evidence.rays);
  evidence.field({"through_wall", "", "Likelihood of a beam through a mapped wall.", kShare},
                 config.evidence.through_wall);
  evidence.field({"off_free_penalty", "nats", "Where base is not on a free cell.", kNats},
                 config.evidence.off_free_penalty);
  evidence.field({"minimum", "nats", "Least log-likelihood of a scan.", kNats},
                 config.evidence.minimum);
}

}  // namespace

void fields(Settings settings, MhAmclConfig& config) {
  rate_fields(settings, config);
  reseed_fields(settings, config.reseed);
  settings.field({"confident", "", "Probability from which the output is confident."},
                 config.match.confident);
  settings.field({"found", "", "Probability from which a lost output is found again."},
                 config.lost_and_found.found);
  settings.field({"select_margin", "nats", "The output stays while less behind.", {0.0, 1e6}},
                 config.select_margin);
  settings.field({"history", "", "Scans that a new population is weighed on.", {1.0, 1000.0}},
                 config.history);
  settings.field({"max_distance", "m", "Cap of the distance field.", {0.01, 1000.0}},
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
