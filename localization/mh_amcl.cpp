#include "localization/mh_amcl.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "localization/filter/correct.hpp"
#include "localization/filter/predict.hpp"

namespace castaway::localization {

MhAmcl::MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock)
    : config_((validate(config), config)),
      seed_(seed),
      map_((validate(map), std::move(map))),
      distances_(map_, config_.max_distance),
      tracking_(config_.tracking, distances_),
      endpoint_(config_.evidence.endpoint, distances_),
      evidence_(config_.evidence, map_, distances_),
      matcher_(config_.matcher, map_, distances_),
      timer_(std::move(clock)),
      intake_(config_.intake),
      panorama_(config_.lidar_memory) {
  if (config_.mode == MhAmclMode::kPaper) paper_ = paper_parts();
  initialize(std::nullopt);
}

void MhAmcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  hypotheses_.clear();
  history_.clear();
  estimate_.reset();
  last_match_.reset();
  pause_s_ = 0.0;
  searches_ = 0;
  search_.reset();
  deeper_ = false;
  rescued_id_ = -1;
  selected_id_ = -1;
  probability_ = 0.0;
  found_ = false;
  was_found_ = false;
  jumped_at_.reset();
  kidnap_hint_ = 0.0;
  unlisted_ = {start ? config_.posterior.wrong_start : 0.0, config_.posterior.usual_start};
  better_since_.reset();
  if (paper_) unlisted_.log_weight = -std::numeric_limits<double>::infinity();
  if (!start) return;
  spawn({start->T_map_base, start->covariance}, 0.0, {unlisted_.usual, 0.0});
  choose();
  found_ = true;
  was_found_ = true;
}

void MhAmcl::on_odometry(const Odometry& odometry) {
  const OdometryIntake taken = intake_.take(odometry);
  if (taken == OdometryIntake::kDropped) return;
  if (taken == OdometryIntake::kRestarted) restart_motion();
  if (!predicted_at_) predicted_at_ = odometry.T_odom_base;
  if (!due(odometry.stamp, last_predict_, config_.predict_rate_hz)) return;
  last_predict_ = odometry.stamp;
  predict(odometry.T_odom_base);
}

void MhAmcl::on_scan(const LaserScan& scan) {
  if (!intake_.accept(scan)) return;
  const Stamp now = intake_.T_odom_base().newest();
  const SE2 T_odom_base = *intake_.T_odom_base().at(now);
  const auto seen = project_scan(scan, intake_.T_odom_base(), now, config_.beams);
  if (!seen) return intake_.drop_scan();
  const ScanPoints points = panorama_.add(scan.lidar, *seen, now, T_odom_base);
  predict(T_odom_base);
  if (paper_) prepare_match(scan, now);
  if (!points.empty() && (!last_correct_ || due(now, *last_correct_, config_.correct_rate_hz))) {
    take_scan(points, now, T_odom_base);
  }
  publish(scan.stamp);
}

/// The clock was set back: what is known of motion, and all times, begin anew. The populations stay
/// where they are.
void MhAmcl::restart_motion() {
  predicted_at_.reset();
  last_predict_ = {};
  last_correct_.reset();
  last_reseed_ = {};
  last_match_.reset();
  better_since_.reset();
  search_.reset();
  deeper_ = false;
  history_.clear();
  jumped_at_.reset();
  panorama_.clear();
  estimate_.reset();
}

/// One scan through the paper's phases.
void MhAmcl::take_scan(const ScanPoints& points, Stamp now, const SE2& T_odom_base) {
  last_correct_ = now;
  timer_.measure("correct", [&] { correct_all(points, T_odom_base); });
  const bool waits = paper_ && config_.paper.published.managed_when_matched;
  const bool managing = !waits || match_due(now, T_odom_base);
  if (managing) timer_.measure("manage", [&] { merge_all(); });
  if (match_due(now, T_odom_base)) {
    timer_.measure("match", [&] { create(now, T_odom_base); });
  }
  if (managing) timer_.measure("manage", [&] { destroy_all(); });
  if (due(now, last_reseed_, config_.reseed_rate_hz)) {
    last_reseed_ = now;
    timer_.measure("reseed", [&] { reseed_all(); });
  }
}

void MhAmcl::correct_all(const ScanPoints& points, const SE2& T_odom_base) {
  if (paper_) {
    correct_all_by_rays(points);
  } else {
    for (Hypothesis& hypothesis : hypotheses_) correct(hypothesis, points);
    rescue(points);
  }
  weigh(points, T_odom_base);
}

void MhAmcl::merge_all() {
  if (paper_) {
    const PaperConfig& paper = config_.paper;
    selected_id_ = merge_by_weight(paper.rules.merge, hypotheses_, paper.published, selected_id_);
  } else {
    merge(config_.merge, hypotheses_);
  }
  choose();
}

void MhAmcl::destroy_all() {
  if (paper_) {
    const PaperConfig& paper = config_.paper;
    selected_id_ = destroy_by_quality(paper.rules, hypotheses_, paper.published, selected_id_);
  } else {
    destroy(config_.destroy, probability_ >= config_.match.confident, hypotheses_);
  }
  if (selected() == nullptr) choose();
}

void MhAmcl::reseed_all() {
  for (Hypothesis& hypothesis : hypotheses_) {
    if (paper_) {
      hypothesis.particles = reseed_losers(config_.paper.reseed, hypothesis.particles,
                                           hypothesis.rng, config_.paper.published);
    } else {
      reseed(hypothesis, std::nullopt);
    }
  }
}

bool MhAmcl::due(Stamp now, Stamp last, double rate_hz) const {
  constexpr double kTolerance = 0.9;  // data come a little early at times
  return seconds(now - last) >= kTolerance / rate_hz;
}

void MhAmcl::predict(const SE2& T_odom_base) {
  const SE2 u = predicted_at_->inverse() * T_odom_base;
  if (u == SE2{}) return;
  const auto move_all = [&](const auto& motion) {
    for (Hypothesis& hypothesis : hypotheses_) {
      localization::predict(hypothesis.particles, motion, hypothesis.rng);
      hypothesis.belief.mean = hypothesis.belief.mean * u;
    }
  };
  timer_.measure("predict", [&] {
    if (paper_ && config_.paper.published.noise_per_step) {
      move_all(StepNoiseMotion(u, config_.paper.step_noise));
    } else {
      move_all(OdometryMotion(u, config_.motion));
    }
  });
  predicted_at_ = T_odom_base;
}

/// Weighs the particles; where few of them still carry the weight, reseeds around the refined
/// winner.
void MhAmcl::correct(Hypothesis& hypothesis, const ScanPoints& points) {
  const PoseMoments predicted = moments(hypothesis.particles);
  localization::correct(hypothesis.particles, tracking_, points);
  const std::vector<double> weights = normalized_weights(hypothesis.particles);
  const auto count = static_cast<double>(weights.size());
  if (effective_size(weights) < config_.reseed.effective_share * count) {
    const auto best = std::max_element(weights.begin(), weights.end()) - weights.begin();
    const Eigen::Matrix3d slack = Eigen::Vector3d(1e-6, 1e-6, 1e-7).asDiagonal();
    const Eigen::Matrix3d prior = (predicted.covariance + slack).inverse();
    const SE2 winner =
        refine_pose(tracking_, points, hypothesis.particles.poses[static_cast<std::size_t>(best)],
                    PosePrior{predicted.mean, prior}, config_.refine);
    const Eigen::Matrix3d information = scan_information(tracking_, points, winner) + prior;
    reseed(hypothesis, PoseGaussian(winner, information.inverse()));
  }
  hypothesis.belief = moments(hypothesis.particles);
}

void MhAmcl::reseed(Hypothesis& hypothesis, const std::optional<PoseGaussian>& winner) {
  const int count = particle_count(config_.reseed, hypothesis.belief.covariance);
  hypothesis.particles = localization::reseed(hypothesis.particles, count, winner, hypothesis.rng);
}

}  // namespace castaway::localization
