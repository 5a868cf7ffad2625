#include "tools/scenario/localizers/posterior_fields.hpp"

namespace castaway::testbed {
namespace {

void doubt_fields(Settings& settings, localization::PosteriorConfig& p) {
  settings.field({"surprise", "nats",
                  "Maximum gain of an unlisted place by the misfit of a scan, per period.", kNats},
                 p.null.surprise);
  settings.field(
      {"false_alarms_per_h",
       "",
       "Tolerated number of false alarms in an hour; sets the doubt that raises an alarm.",
       {1e-6, 14400.0}},
      p.null.false_alarms_per_h);
  settings.field({"rare_misfit",
                  "",
                  "Share of the scans at a right pose whose fit says nothing.",
                  {1e-6, 0.5}},
                 p.null.rare_misfit);
  settings.field(
      {"least_spread", "nats", "Minimum of the spread by which a misfit is judged.", {1e-3, 100.0}},
      p.null.least_spread);
  settings.field({"wrong_range",
                  "nats",
                  "Range over which the fit at a wrong pose is spread evenly.",
                  {1.0, 1000.0}},
                 p.null.wrong_range);
  settings.field({"most_doubt", "nats", "Maximum doubt.", kNats}, p.null.most_doubt);
  settings.field(
      {"better", "nats", "A place is better than the output if it leads by this.", kNats},
      p.null.better);
  settings.field(
      {"better_doubt", "nats",
       "Doubt that a better place elsewhere adds if the scan fits perfectly there.", kNats},
      p.null.better_doubt);
  settings.field({"better_fits",
                  "nats",
                  "A better place where the scan fits worse adds no doubt.",
                  {-1000.0, -0.001}},
                 p.null.better_fits);
  settings.field({"settle_rate", "",
                  "Weight in the running average of a watch that finds nothing better.", kShare},
                 p.null.settle_rate);
  settings.field({"settle_spread_rate", "", "The same of the spread.", kShare},
                 p.null.settle_spread_rate);
}

void missed_fields(Settings& settings, localization::PosteriorConfig& p) {
  settings.field({"missed_lead",
                  "",
                  "Fall of these log-odds per nat that the best place is ahead of the next one.",
                  {0.0, 100.0}},
                 p.null.missed_lead);
  settings.field({"output_lead",
                  "",
                  "The same per nat that a confident output is ahead of all other places.",
                  {0.0, 100.0}},
                 p.null.output_lead);
  settings.field(
      {"watch_missed", "nats", "Log-probability that a watch misses the right place.", kNats},
      p.null.watch_missed);
  settings.field({"most_lead", "nats", "Maximum lead that counts.", kNats}, p.null.most_lead);
}

void unlisted_fields(Settings& settings, localization::PosteriorConfig& p) {
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
  settings.field(
      {"place", "nats", "Log-probability per period that the robot was brought to one given place.",
       kNats},
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

void kidnap_fields(Settings& settings, localization::PosteriorConfig& p) {
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

}  // namespace

void fields(Settings settings, localization::ScanAgreementConfig& agreement) {
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

void fields(Settings settings, localization::ScanContinuityConfig& continuity) {
  fields(settings.group("agreement"), continuity.agreement);
  settings.field({"tolerance_per_m", "m", "Growth of the tolerance per metre moved.", kLength},
                 continuity.tolerance_per_m);
  settings.field({"tolerance_per_rad", "",
                  "Growth of the tolerance's share of the range per radian turned.", kShare},
                 continuity.tolerance_per_rad);
  settings.field({"most_moved", "m", "Scans that are farther apart are not compared.", kLength},
                 continuity.most_moved);
  settings.field({"most_turned", "rad", "Scans that are turned by more are not compared.", kAngle},
                 continuity.most_turned);
  settings.field({"spread_start", "", "Initial spread of the agreement.", kShare},
                 continuity.spread_start);
  settings.field({"least_spread", "", "Minimum spread.", kShare}, continuity.least_spread);
  settings.field({"rate", "", "Least weight of a scan in the running averages.", kShare},
                 continuity.rate);
  settings.field({"limit",
                  "",
                  "Maximum deviation that is learned, as a multiple of the spread.",
                  {0.0, 100.0}},
                 continuity.limit);
  settings.field(
      {"free", "", "Deviation without an effect, as a multiple of the spread.", {0.0, 100.0}},
      continuity.free);
  settings.field({"most", "nats", "Maximum evidence for a kidnap.", kNats}, continuity.most);
}

void fields(Settings settings, localization::PosteriorConfig& p) {
  settings.field({"independent_m", "m", "Distance after which a scan is independent.", kLength},
                 p.scans.independent_m);
  settings.field({"independent_rad", "rad", "Rotation after which a scan is independent.", kAngle},
                 p.scans.independent_rad);
  settings.field({"least_independence", "", "Independent share of a scan at rest.", kShare},
                 p.scans.least_independence);
  unlisted_fields(settings, p);
  missed_fields(settings, p);
  doubt_fields(settings, p);
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

}  // namespace castaway::testbed
