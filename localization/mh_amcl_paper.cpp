// Modes `paper` and `published` of MH-AMCL: populations come from the cascade and are selected by
// their quality.
#include <algorithm>
#include <string>

#include "localization/mh_amcl.hpp"

namespace castaway::localization {
namespace {
constexpr double kUntriedQuality = 0.25;  // of a new population in the published code
}

MhAmcl::PaperParts MhAmcl::paper_parts() const {
  const PaperConfig& paper = config_.paper;
  RayLocalConfig sensor = paper.sensor;
  sensor.clamped_density = paper.published.summed_weights;
  return {RayLocalModel(sensor, map_),
          PaperCascade(paper.cascade, paper.sensor, map_, paper.published),
          {}};
}

/// Keeps what the matcher of the published code sees of a scan.
void MhAmcl::prepare_match(const LaserScan& scan, Stamp now) {
  if (!config_.paper.published.mount_ignored) return;
  LaserScan unmounted = scan;
  unmounted.T_base_laser.setIdentity();
  paper_->unmounted = project_scan(unmounted, intake_.T_odom_base(), now, config_.beams).value();
}

void MhAmcl::correct_all_by_rays(const ScanPoints& points) {
  for (Hypothesis& hypothesis : hypotheses_) {
    correct_by_rays(hypothesis, paper_->model, points, config_.paper.published);
  }
  if (const Hypothesis* output = selected()) probability_ = output->quality;
}

void MhAmcl::choose_by_quality() {
  if (hypotheses_.empty()) return;
  if (config_.paper.published.absolute_gates) {
    selected_id_ = output_by_gates(config_.paper.rules.gates, hypotheses_, selected_id_);
  } else {
    choose_after_a_while();
  }
  probability_ = selected()->quality;
}

/// The best population, unless the present one is hardly worse or was worse only for a moment.
void MhAmcl::choose_after_a_while() {
  const QualityRules& rules = config_.paper.rules;
  const Hypothesis& other = hypotheses_[*best_by_quality(hypotheses_)];
  const Hypothesis* present = selected();
  const bool better = present == nullptr || other.quality > present->quality + rules.select_margin;
  if (!better) better_since_.reset();
  if (better && !better_since_) better_since_ = last_correct_;
  const bool long_enough =
      better && (present == nullptr || seconds(*last_correct_ - *better_since_) >= rules.select_s);
  if (!long_enough) return;
  selected_id_ = other.id;
  better_since_.reset();
}

/// New populations where the cascade finds the scan, far from those there are.
bool MhAmcl::spawn_by_quality(const ScanPoints& points) {
  const PaperConfig& paper = config_.paper;
  const QualityRules& rules = paper.rules;
  const double s = paper.spawn_sigma;
  const double r = paper.spawn_sigma_yaw;
  const std::size_t before = hypotheses_.size();
  const ScanPoints& matched = paper.published.mount_ignored ? paper_->unmounted : points;
  for (const Candidate& candidate : paper_->cascade.match(matched)) {
    if (hypotheses_.size() >= static_cast<std::size_t>(rules.most)) break;
    if (candidate.score < rules.candidate_from) break;
    if (!is_apart(rules, hypotheses_, candidate.T_map_base)) continue;
    spawn({candidate.T_map_base, Eigen::Vector3d(s * s, s * s, r * r).asDiagonal()}, 0.0, {});
    if (paper.published.managed_when_matched) {
      hypotheses_.back().quality = kUntriedQuality;
    } else {
      correct_by_rays(hypotheses_.back(), paper_->model, points, paper.published);
    }
  }
  return hypotheses_.size() > before;
}

}  // namespace castaway::localization
