// Settings of the paper's MH-AMCL and of the published code.
#include "tools/scenario/localizers/filter_fields.hpp"
#include "tools/scenario/localizers/mh_amcl_fields.hpp"

namespace castaway::testbed {
namespace {

using localization::LoserReseedConfig;
using localization::PaperCascadeConfig;
using localization::PaperMhAmclConfig;
using localization::PublishedGates;
using localization::PublishedMhAmclConfig;
using localization::QualityRules;

void fields(Settings settings, LoserReseedConfig& reseed) {
  settings.field({"losers", "", "Share of the particles that are replaced.", kShare},
                 reseed.losers);
  settings.field({"winners", "", "Share of the particles that are copied.", kShare},
                 reseed.winners);
  settings.field({"spread_m", "m", "Standard deviation of a copy around its winner.", kLength},
                 reseed.spread_m);
  settings.field({"spread_rad", "rad", "Standard deviation of a copy's yaw.", kAngle},
                 reseed.spread_rad);
  settings.field({"min_particles", "", "Minimum number of particles.", kCount},
                 reseed.min_particles);
  settings.field({"max_particles", "", "Maximum number of particles.", kCount},
                 reseed.max_particles);
  settings.field({"step", "", "Number of particles added or removed at a time.", kCount},
                 reseed.step);
  settings.field({"high_spread_m", "m", "Particles are added above this spread.", kLength},
                 reseed.high_spread_m);
  settings.field({"low_spread_m", "m", "Particles are removed below this spread.", kLength},
                 reseed.low_spread_m);
}

void fields(Settings settings, PaperCascadeConfig& cascade) {
  settings.field({"levels", "", "Number of levels; each doubles the cell size.", {1.0, 12.0}},
                 cascade.levels);
  settings.field(
      {"finest_level", "", "Level at which the search ends; 0: the map's cells.", {0.0, 12.0}},
      cascade.finest_level);
  settings.field({"yaw_step", "rad", "Step of the yaw.", {0.01, 3.2}}, cascade.yaw_step);
  settings.field({"threshold", "", "Minimum quality of a candidate at any level.", kShare},
                 cascade.threshold);
  settings.field({"apart_m", "m", "Minimum distance between two candidates.", kLength},
                 cascade.apart_m);
  settings.field(
      {"max_per_level", "", "Maximum number of candidates passed to the next level.", kCount},
      cascade.max_per_level);
}

void fields(Settings settings, QualityRules& rules) {
  fields(settings.group("merge"), rules.merge);
  settings.field({"destroy_below", "", "Populations of lower quality are removed.", kShare},
                 rules.destroy_below);
  settings.field(
      {"candidate_from", "", "Minimum quality at which a candidate becomes a population.", kShare},
      rules.candidate_from);
  settings.field({"apart_m", "m", "Minimum distance of a new population from all others.", kLength},
                 rules.apart_m);
  settings.field({"apart_rad", "rad", "Alternatively, minimum difference in yaw.", kAngle},
                 rules.apart_rad);
  settings.field({"select_margin", "",
                  "To become the output, a population must be better by this margin.", kShare},
                 rules.select_margin);
  settings.field(
      {"select_s", "s", "To become the output, a population must be better for this long.", kTime},
      rules.select_s);
  settings.field({"right_from", "", "Minimum quality of an output that is not lost.", kShare},
                 rules.right_from);
  settings.field({"most", "", "Maximum number of populations.", {1.0, 1000.0}}, rules.most);
}

}  // namespace

void fields(Settings settings, PaperMhAmclConfig& config) {
  rate_fields(settings, config);
  reseed_fields(settings, config.size);
  settings.field({"match_period_s", "s", "Time between two matches.", {1e-3, 1e6}},
                 config.match_period_s);
  settings.field({"candidate_sigma", "m", "Standard deviation of a candidate.", kLength},
                 config.candidate_sigma);
  settings.field({"candidate_sigma_yaw", "rad", "Standard deviation of a candidate's yaw.", kAngle},
                 config.candidate_sigma_yaw);
  settings.group("sensor").field({"sigma", "m", "Accuracy of the sensor.", {1e-6, 100.0}},
                                 config.sensor.sigma);
  fields(settings.group("reseed"), config.reseed);
  fields(settings.group("cascade"), config.cascade);
  fields(settings.group("rules"), config.rules);
  fields(settings.group("spawn"), config.spawn);
}

void fields(Settings settings, PublishedMhAmclConfig& config) {
  fields(settings, config.paper);
  settings.form({"defects", "", "Defects of the published code: a list of names."}, "all");
}

}  // namespace castaway::testbed
