#include "localization/paper/paper_mh_amcl.hpp"

#include <utility>
#include <vector>

#include "localization/mh_amcl/output.hpp"

namespace castaway::localization {
namespace {

void select_by_stages(const PaperStages& stages, Stamp now, PaperBelief& belief) {
  if (belief.populations.all.empty()) return;
  belief.select(stages.prefer(belief.populations), now);
}

}  // namespace

PaperMhAmcl::PaperMhAmcl(const PaperMhAmclConfig& config, const OccupancyGrid& map,
                         std::uint64_t seed, StageClock clock)
    : PaperMhAmcl(config, paper_stages((validate(config), config), map), seed, std::move(clock)) {}

PaperMhAmcl::PaperMhAmcl(const PaperMhAmclConfig& config, PaperStages stages, std::uint64_t seed,
                         StageClock clock)
    : config_((validate(config), config)),
      stages_(std::move(stages)),
      input_(config_.input),
      belief_(config_, stages_.patience_s, seed),
      timer_(std::move(clock)) {}

void PaperMhAmcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  belief_.clear();
  last_match_.reset();
  estimate_.reset();
  if (!start) return;
  belief_.add({start->T_map_base, start->covariance});
  select_by_stages(stages_, Stamp{}, belief_);
}

void PaperMhAmcl::on_odometry(const Odometry& odometry) {
  const OdometryTurn turn = input_.take(odometry);
  if (turn.restarted) {  // The populations keep their poses.
    belief_.patience.reset();
    last_match_.reset();
    estimate_.reset();
  }
  predict(turn.step);
}

void PaperMhAmcl::on_scan(const LaserScan& scan) {
  const auto turn = input_.take(scan);
  if (!turn) return;
  predict(turn->step);
  if (turn->counts) take_scan({scan, *turn, input_.intake().T_odom_base()});
  const Populations& populations = belief_.populations;
  estimate_ =
      estimate_of(populations, belief_.shares(), populations.probability < config_.rules.right_from,
                  scan.stamp, input_.T_now_base(scan.stamp));
}

void PaperMhAmcl::predict(const std::optional<SE2>& step) {
  if (step) timer_.measure("predict", [&] { stages_.predict(*step, belief_.populations.all); });
}

/// Processes one scan in the phases of the paper.
void PaperMhAmcl::take_scan(const MatchScan& scan) {
  Populations& populations = belief_.populations;
  const Stamp now = scan.turn.now;
  timer_.measure("correct", [&] {
    for (Hypothesis& hypothesis : populations.all) stages_.correct(scan.turn.points, hypothesis);
    belief_.update_probability();
  });
  const bool matches = !last_match_ || seconds(now - *last_match_) >= config_.match_period_s;
  const bool manages = stages_.manages_always || matches;
  if (manages) {
    timer_.measure("manage", [&] {
      stages_.merge(populations);
      select_by_stages(stages_, now, belief_);
    });
  }
  if (matches) timer_.measure("match", [&] { create(scan); });
  if (manages) {
    timer_.measure("manage", [&] {
      stages_.destroy(populations);
      if (populations.output() == nullptr) select_by_stages(stages_, now, belief_);
    });
  }
  if (!scan.turn.reseeds) return;
  timer_.measure("reseed", [&] {
    for (Hypothesis& hypothesis : populations.all) stages_.reseed(hypothesis);
  });
}

/// Creates populations where the matcher finds the scan, apart from the existing ones.
void PaperMhAmcl::create(const MatchScan& scan) {
  last_match_ = scan.turn.now;
  const QualityRules& rules = config_.rules;
  const std::vector<Hypothesis>& present = belief_.populations.all;
  const double s = config_.candidate_sigma;
  const double r = config_.candidate_sigma_yaw;
  const Eigen::Matrix3d spread = Eigen::Vector3d(s * s, s * s, r * r).asDiagonal();
  for (const Candidate& candidate : stages_.match(scan)) {
    if (present.size() >= static_cast<std::size_t>(rules.most)) break;
    if (candidate.score < rules.candidate_from) break;
    if (!is_apart(rules, present, candidate.T_map_base)) continue;
    stages_.judge_new(scan.turn.points, belief_.add({candidate.T_map_base, spread}));
  }
  stages_.merge(belief_.populations);
  select_by_stages(stages_, scan.turn.now, belief_);
}

Diagnostics PaperMhAmcl::diagnostics() const {
  return diagnostics_of(belief_.populations, belief_.shares(), input_.intake(), timer_);
}

}  // namespace castaway::localization
