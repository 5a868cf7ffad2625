#include "tools/scenario/localizers/search_fields.hpp"

namespace castaway::testbed {
namespace {

void fields(Settings settings, localization::ByteFieldConfig& field) {
  settings.field({"resolution", "m", "Cell size of the coarse search.", kLength}, field.resolution);
  settings.field({"sigma", "m", "Standard deviation of end points around walls.", kLength},
                 field.sigma);
  settings.field({"padding", "m", "Width of the border of zeros around the map.", kLength},
                 field.padding);
}

void pause_fields(Settings& settings, localization::PlaceWatchConfig& watch) {
  settings.field({"pause_s", "s", "Minimum time between searches on suspicion.", kTime},
                 watch.pause_s);
  settings.field({"fits_badly", "nats",
                  "A less likely scan is unusual, as is one that is less likely than usual by more "
                  "than the mean deviation.",
                  kNats},
                 watch.fits_badly);
  settings.field({"first_pause_s", "s",
                  "Minimum time between searches in the background while the scan is unusual; "
                  "doubles each time.",
                  kTime},
                 watch.first_pause_s);
  settings.field(
      {"longest_pause_s", "s", "Upper limit of this time, and the time otherwise.", kTime},
      watch.longest_pause_s);
  settings.field({"usual_scans", "",
                  "Minimum number of scans from a search to the next one in the background while "
                  "they are not unusual.",
                  kCount},
                 watch.usual_scans);
}

}  // namespace

void fields(Settings settings, localization::MatcherConfig& matcher) {
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
                  {{"branch_and_bound", localization::MatchAlgorithm::kBranchAndBound},
                   {"exhaustive", localization::MatchAlgorithm::kExhaustive}});
  settings.field({"levels", "", "Number of levels of the branch and bound pyramid.", {1.0, 8.0}},
                 matcher.levels);
}

void fields(Settings settings, localization::MatchScheduleConfig& match) {
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

void fields(Settings settings, localization::PlaceWatchConfig& watch) {
  int slice = static_cast<int>(watch.slice);
  int burst = static_cast<int>(watch.burst);
  settings.field({"score_share", "",
                  "A place is found if it scores this share of the output's score.", kShare},
                 watch.score_share);
  settings.field({"candidates", "", "Maximum number of places found.", kCount}, watch.candidates);
  settings.field({"refined", "", "Number of places that are refined.", kCount}, watch.refined);
  settings.field(
      {"slice", "", "Number of tiles searched per period in the background.", {1.0, 1e9}}, slice);
  settings.field({"burst", "", "Number of tiles searched per period on suspicion.", {1.0, 1e9}},
                 burst);
  settings.field(
      {"suspicious_cue", "nats", "Evidence for a kidnap in a scan that is suspicious.", kNats},
      watch.suspicious_cue);
  settings.field({"suspicious_doubt", "nats", "Doubt that is suspicious.", kNats},
                 watch.suspicious_doubt);
  settings.field({"alarming", "", "A smaller probability of the output is suspicious."},
                 watch.alarming);
  pause_fields(settings, watch);
  watch.slice = slice;
  watch.burst = burst;
}

void fields(Settings settings, localization::RescueConfig& rescue) {
  settings.field(
      {"drop", "nats",
       "A rescue starts if the scan at the output is less likely than usual by this, divided by "
       "the periods since the scan before.",
       kNats},
      rescue.drop);
  settings.field(
      {"sparse_periods", "",
       "After so many periods without a scan, it starts wherever the scan fits badly.", kCount},
      rescue.sparse_periods);
  settings.field({"radius", "m", "Position range of the search around the output.", kLength},
                 rescue.radius);
  settings.field({"yaw_radius", "rad", "Yaw range of the search around the output.", kAngle},
                 rescue.yaw_radius);
  settings.field({"candidates", "", "Maximum number of candidates that are refined.", kCount},
                 rescue.candidates);
  settings.field({"refined_behind", "nats",
                  "Candidates that fit worse than the output by more before refinement are not "
                  "refined.",
                  kNats},
                 rescue.refined_behind);
  settings.field({"gain", "nats", "Minimum improvement by the place found.", kNats}, rescue.gain);
  settings.field(
      {"cost", "nats",
       "A place at the edge of the search starts with the output's weight minus this.", kNats},
      rescue.cost);
  settings.field({"cost_near", "nats", "The same next to the output.", kNats}, rescue.cost_near);
  settings.field(
      {"cost_on_way", "nats",
       "The same on the way of the last step, if the output fits worse than usual by `drop`.",
       kNats},
      rescue.cost_on_way);
  settings.field({"cost_on_way_unnoticed", "nats", "The same if it does not.", kNats},
                 rescue.cost_on_way_unnoticed);
  settings.field(
      {"long_step", "m or rad",
       "The way of a longer step is searched where the output fits worse than usual.", kLength},
      rescue.long_step);
  settings.field(
      {"spacing", "m or rad", "Distance between the poses searched on the way.", {0.001, 10.0}},
      rescue.spacing);
  settings.field({"beside_way", "m", "Maximum distance from that way.", kLength},
                 rescue.beside_way);
}

void fields(Settings settings, localization::CreateConfig& create) {
  settings.field(
      {"far_share", "",
       "A deep search uses this share of the end points, the farthest ones; 0: all.", kShare},
      create.far_share);
  settings.field({"quick_candidates", "", "Number of places of the first search.", kCount},
                 create.quick_candidates);
  settings.field(
      {"deep_below", "nats", "If the best place scores less, a deep search follows.", kNats},
      create.deep_below);
  settings.field({"deep_candidates", "", "Maximum number of places of a deep search.", kCount},
                 create.deep_candidates);
  settings.field({"first_deep", "", "Number of places if the best one nearly fits.", kCount},
                 create.first_deep);
  settings.field({"deep_growth",
                  "",
                  "Growth of the logarithm of that number per nat that the best place fits worse.",
                  {0.0, 100.0}},
                 create.deep_growth);
  settings.field({"settled_beams",
                  "",
                  "Beams on which candidates climb before their evidence is computed; 0: none.",
                  {0, 100000}},
                 create.settled_beams);
  fields(settings.group("settle"), create.settle);
  settings.field({"looked_at", "", "Number of candidates whose evidence is computed.", kCount},
                 create.looked_at);
  settings.field({"refined", "", "Number of candidates that are refined.", kCount}, create.refined);
  settings.field(
      {"refined_behind", "nats", "Candidates further behind the best one are not refined.", kNats},
      create.refined_behind);
  settings.field({"keep", "", "Number of candidates that are weighted by older scans.", kCount},
                 create.keep);
  fields(settings.group("refine"), create.refine);
  fields(settings.group("refine_last"), create.refine_last);
  fields(settings.group("refine_back"), create.refine_back);
}

}  // namespace castaway::testbed
