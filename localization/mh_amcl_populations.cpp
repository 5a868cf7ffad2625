// How populations of MH-AMCL come into being: rescue and creation.
#include <algorithm>
#include <string>

#include "localization/mh_amcl.hpp"

namespace castaway::localization {

/// Looks around when the output suddenly fits badly, and lists a place near by where the scan fits
/// better. It begins with the output's evidence less the cost of the slip, so that one scan in a
/// crowd does not carry the output away.
void MhAmcl::rescue(const ScanPoints& points) {
  const Hypothesis* output = selected();
  if (output == nullptr) return;
  const double now = evidence_.evaluate(points, output->belief.mean).log_likelihood;
  if (now > unlisted_.usual - config_.rescue.drop) return;
  const MatchWindow window{output->belief.mean, config_.rescue.radius, config_.rescue.yaw_radius};
  std::vector<Candidate> candidates = matcher_.match(points, window);
  candidates.resize(
      std::min(candidates.size(), static_cast<std::size_t>(config_.rescue.candidates)));
  const std::vector<WeighedPlace> places = refine_candidates(create_context(), candidates, points);
  if (places.empty() || places[0].newest.log_likelihood < now + config_.rescue.gain) return;
  const SE2 pose = places[0].T_map_base;
  const Eigen::Matrix3d slack = Eigen::Vector3d(1.0, 1.0, 1.0).asDiagonal();
  const Eigen::Matrix3d information = scan_information(tracking_, points, pose) + slack;
  const Evidence before{output->log_likelihood, output->quality};
  spawn({pose, information.inverse()}, output->log_weight - config_.rescue.cost, before);
  rescued_id_ = hypotheses_.back().id;
}

/// Whether the newest scan fits nowhere that is listed.
bool MhAmcl::hopeless() const {
  return std::all_of(hypotheses_.begin(), hypotheses_.end(), [&](const Hypothesis& h) {
    return h.log_likelihood < config_.posterior.hopeless;
  });
}

bool MhAmcl::match_due(Stamp now, const SE2& T_odom_base) const {
  if (search_ || deeper_) return true;
  if (paper_) return !last_match_ || seconds(now - *last_match_) >= config_.paper.match_period_s;
  if (rescued_id_ >= 0 && selected_id_ == rescued_id_) return true;  // a look-alike near by?
  if (probability_ >= config_.match.confident) return false;
  if (!last_match_ || searches_ < config_.match.at_once) return true;
  const double waited = seconds(now - *last_match_);
  if (hopeless()) return waited >= config_.match.first_pause_s;
  if (waited < pause_s_) return false;
  return distance(matched_at_, T_odom_base) >= config_.match.moved_m ||
         yaw_distance(matched_at_, T_odom_base) >= config_.match.turned_rad ||
         waited >= config_.match.patience_s;
}

/// Asks the matcher; pauses longer and longer while it changes nothing.
void MhAmcl::create(Stamp now, const SE2& T_odom_base) {
  const int before = selected_id_;
  last_match_ = now;
  rescued_id_ = -1;
  matched_at_ = T_odom_base;
  const ScanPoints& points = history_.back().points;
  if (!paper_ && !search_) begin_search(points, T_odom_base);
  if (!paper_ && !search_->step(config_.match.slice)) return;
  const bool grown = paper_ ? spawn_by_quality(points) : end_search(points, T_odom_base);
  merge_all();
  const bool changed = grown && selected_id_ != before;
  pause_s_ = changed ? config_.match.first_pause_s
                     : std::clamp(2.0 * pause_s_, config_.match.first_pause_s,
                                  config_.match.longest_pause_s);
}

CreateContext MhAmcl::create_context() const {
  return {config_.create, config_.merge, config_.posterior, config_.motion, endpoint_, evidence_};
}

void MhAmcl::begin_search(const ScanPoints& points, const SE2& T_odom_base) {
  const SearchDepth depth = deeper_ ? SearchDepth::kDeep : SearchDepth::kUsual;
  search_.emplace(config_.create, matcher_, points, T_odom_base, depth);
  deeper_ = false;
  if (depth == SearchDepth::kUsual) ++searches_;
}

/// Takes what the search found; whether anything was listed. Where nothing fits well, the next scan
/// is searched deeper.
bool MhAmcl::end_search(const ScanPoints& points, const SE2& T_odom_base) {
  const CreateContext context = create_context();
  const std::vector<WeighedPlace> places = refine_candidates(
      context, sort_out(context, search_->candidates(T_odom_base), points), points);
  deeper_ = search_->depth() == SearchDepth::kUsual && fits_badly(config_.create, places);
  search_.reset();
  return spawn_places(places, points);
}

/// Lists the places where the newest scan fits, unless they are far behind those already listed.
bool MhAmcl::spawn_places(std::vector<WeighedPlace> places, const ScanPoints& points) {
  const CreateContext context = create_context();
  const std::size_t before = hypotheses_.size();
  double best = listed_log_weight(hypotheses_);
  if (!places.empty()) {
    lower_usual(config_.posterior, places[0].newest.log_likelihood, unlisted_);
  }
  for (WeighedPlace& place : places) {
    const bool known = std::any_of(hypotheses_.begin(), hypotheses_.end(), [&](const auto& h) {
      return same_place(config_.merge, h.belief.mean, place.T_map_base) &&
             h.log_likelihood > place.newest.log_likelihood - 1.0;
    });
    if (known) continue;
    place.log_weight = weigh_backwards(context, history_, place);
    if (place.log_weight < best - config_.destroy.behind) continue;
    best = std::max(best, place.log_weight);
    Eigen::Matrix3d information = scan_information(tracking_, points, place.T_map_base);
    information += Eigen::Vector3d(1.0, 1.0, 1.0).asDiagonal();
    spawn({place.T_map_base, information.inverse()}, place.log_weight, place.newest);
  }
  if (!places.empty()) {
    bound_unlisted(config_.posterior, places[0].newest.log_likelihood,
                   listed_log_weight(hypotheses_), unlisted_);
  }
  return hypotheses_.size() > before;
}

void MhAmcl::spawn(const PoseMoments& belief, double log_weight, const Evidence& evidence) {
  const double s = config_.spawn_sigma;
  const double r = config_.spawn_sigma_yaw;
  const Eigen::Matrix3d least = Eigen::Vector3d(s * s, s * s, r * r).asDiagonal();
  Hypothesis hypothesis;
  hypothesis.id = next_id_++;
  hypothesis.rng = substream(seed_, "population/" + std::to_string(hypothesis.id));
  hypothesis.belief = {belief.mean, belief.covariance + least};
  hypothesis.particles =
      draw_particles(PoseGaussian(belief.mean, hypothesis.belief.covariance),
                     particle_count(config_.reseed, hypothesis.belief.covariance), hypothesis.rng);
  hypothesis.log_weight = log_weight;
  hypothesis.log_likelihood = evidence.log_likelihood;
  hypothesis.quality = evidence.quality;
  hypotheses_.push_back(std::move(hypothesis));
}

}  // namespace castaway::localization
