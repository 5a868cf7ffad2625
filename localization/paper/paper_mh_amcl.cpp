#include "localization/paper/paper_mh_amcl.hpp"

#include <limits>
#include <utility>

#include "localization/output.hpp"

namespace castaway::localization {
namespace {

/// Shares by quality; the paper has no null hypothesis.
std::vector<double> shares_of(const Populations& populations) {
  return shares(populations.all, {.log_weight = -std::numeric_limits<double>::infinity()});
}

}  // namespace

PaperMhAmcl::PaperMhAmcl(const PaperMhAmclConfig& config, const OccupancyGrid& map,
                         std::uint64_t seed, StageClock clock)
    : PaperMhAmcl(config, paper_stages((validate(config), config), map), seed, std::move(clock)) {}

PaperMhAmcl::PaperMhAmcl(const PaperMhAmclConfig& config, PaperStages stages, std::uint64_t seed,
                         StageClock clock)
    : config_((validate(config), config)),
      stages_(std::move(stages)),
      timer_(std::move(clock)),
      input_({config_.predict_rate_hz, config_.correct_rate_hz, config_.reseed_rate_hz,
              config_.beams, config_.intake, config_.lidar_memory}),
      spawner_(config_.spawn, config_.size, seed),
      patience_(stages_.patience_s) {}

void PaperMhAmcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  populations_ = {};
  patience_.reset();
  last_match_.reset();
  estimate_.reset();
  if (!start) return;
  populations_.all.push_back(spawner_.spawn({start->T_map_base, start->covariance}, 0.0, {}));
  select(Stamp{});
}

void PaperMhAmcl::on_odometry(const Odometry& odometry) {
  const OdometryTurn turn = input_.take(odometry);
  if (turn.restarted) {  // The populations keep their poses.
    patience_.reset();
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
  estimate_ = estimate_of(populations_, shares_of(populations_),
                          populations_.probability < config_.rules.right_from, scan.stamp,
                          input_.T_now_base(scan.stamp));
}

/// Processes one scan in the phases of the paper.
void PaperMhAmcl::take_scan(const MatchScan& scan) {
  const Stamp now = scan.turn.now;
  timer_.measure("correct", [&] { correct(scan.turn.points); });
  const bool matches = !last_match_ || seconds(now - *last_match_) >= config_.match_period_s;
  const bool manages = stages_.manages_always || matches;
  if (manages) {
    timer_.measure("manage", [&] {
      stages_.merge(populations_);
      select(now);
    });
  }
  if (matches) timer_.measure("match", [&] { create(scan); });
  if (manages) {
    timer_.measure("manage", [&] {
      stages_.destroy(populations_);
      if (populations_.output() == nullptr) select(now);
    });
  }
  if (!scan.turn.reseeds) return;
  timer_.measure("reseed", [&] {
    for (Hypothesis& hypothesis : populations_.all) stages_.reseed(hypothesis);
  });
}

void PaperMhAmcl::predict(const std::optional<SE2>& step) {
  if (step) timer_.measure("predict", [&] { stages_.predict(*step, populations_.all); });
}

void PaperMhAmcl::correct(const ScanPoints& points) {
  for (Hypothesis& hypothesis : populations_.all) stages_.correct(points, hypothesis);
  if (const Hypothesis* output = populations_.output()) populations_.probability = output->quality;
}

/// Creates populations where the matcher finds the scan, apart from the existing ones.
void PaperMhAmcl::create(const MatchScan& scan) {
  last_match_ = scan.turn.now;
  const QualityRules& rules = config_.rules;
  const double s = config_.candidate_sigma;
  const double r = config_.candidate_sigma_yaw;
  const Eigen::Matrix3d spread = Eigen::Vector3d(s * s, s * s, r * r).asDiagonal();
  for (const Candidate& candidate : stages_.match(scan)) {
    if (populations_.all.size() >= static_cast<std::size_t>(rules.most)) break;
    if (candidate.score < rules.candidate_from) break;
    if (!is_apart(rules, populations_.all, candidate.T_map_base)) continue;
    populations_.all.push_back(spawner_.spawn({candidate.T_map_base, spread}, 0.0, {}));
    stages_.judge_new(scan.turn.points, populations_.all.back());
  }
  stages_.merge(populations_);
  select(scan.turn.now);
}

void PaperMhAmcl::select(Stamp now) {
  if (populations_.all.empty()) return;
  const bool is_there = populations_.output() != nullptr;
  const std::optional<int> present =
      is_there ? std::optional<int>(populations_.output_id) : std::nullopt;
  populations_.output_id = patience_.settle(present, stages_.prefer(populations_), now);
  populations_.probability = populations_.output()->quality;
}

Diagnostics PaperMhAmcl::diagnostics() const {
  return diagnostics_of(populations_, shares_of(populations_), input_.intake(), timer_);
}

}  // namespace castaway::localization
