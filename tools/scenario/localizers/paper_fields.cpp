// Settings of the paper's MH-AMCL and of the published code.
#include "tools/scenario/localizers/filter_fields.hpp"
#include "tools/scenario/localizers/mh_amcl_fields.hpp"

namespace castaway::testbed {
namespace {

using localization::PaperCascadeConfig;
using localization::PaperMhAmclConfig;
using localization::PublishedMhAmclConfig;
using localization::QualityRules;

void fields(Settings settings, PaperCascadeConfig& cascade) {
  settings.field({"levels", "", "Number of levels; each doubles the cell size.", {1.0, 12.0}},
                 cascade.levels);
  settings.field({"threshold", "", "Minimum quality of a candidate at any level.", kShare},
                 cascade.threshold);
}

void fields(Settings settings, QualityRules& rules) {
  settings.field({"destroy_below", "", "Populations of lower quality are removed.", kShare},
                 rules.destroy_below);
  settings.field(
      {"candidate_from", "", "Minimum quality at which a candidate becomes a population.", kShare},
      rules.candidate_from);
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
  size_fields(settings, config.size);
  settings.field({"match_period_s", "s", "Time between two matches.", {1e-3, 1e6}},
                 config.match_period_s);
  settings.group("sensor").field({"sigma", "m", "Accuracy of the sensor.", {1e-6, 100.0}},
                                 config.sensor.sigma);
  fields(settings.group("cascade"), config.cascade);
  fields(settings.group("rules"), config.rules);
}

void fields(Settings settings, PublishedMhAmclConfig& config) {
  fields(settings, config.paper);
  settings.form({"defects", "", "Defects of the published code: a list of names."}, "all");
}

}  // namespace castaway::testbed
