#include "localization/hypotheses/create.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <set>

namespace castaway::localization {
namespace {

/// The pose at the scan before, from odometry's step back, refined within odometry's noise.
SE2 step_back(const CreateContext& context, const SE2& T_map_base, const ScanMemory& later,
              const ScanMemory& earlier) {
  const SE2 u = later.T_odom_base.inverse() * earlier.T_odom_base;
  const SE2 predicted = T_map_base * u;
  const OdometryMotion motion(u, context.noise);
  const Eigen::Matrix3d slack = Eigen::Vector3d(1e-4, 1e-4, 1e-5).asDiagonal();
  const Eigen::Matrix3d spread = rotated_to_map(motion.covariance(), T_map_base.yaw) + slack;
  return refine_pose(context.model, earlier.points, predicted,
                     PosePrior{predicted, spread.inverse()}, context.config.refine_back);
}

constexpr int kGlance = 24;  // beams that sort out long lists

/// The best `most` candidates by the evidence of their coarse pose, which becomes their score.
void screen(const EvidenceModel& evidence, const ScanPoints& points, int most,
            std::vector<Candidate>& candidates) {
  for (Candidate& candidate : candidates) {
    candidate.score = evidence.evaluate(points, candidate.T_map_base).log_likelihood;
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  if (candidates.size() > static_cast<std::size_t>(most)) {
    candidates.erase(candidates.begin() + most, candidates.end());
  }
}

/// Adds what is not yet listed.
void join(const std::vector<Candidate>& more, std::vector<Candidate>& candidates) {
  const auto key = [](const SE2& pose) { return std::array{pose.x, pose.y, pose.yaw}; };
  std::set<std::array<double, 3>> known;
  for (const Candidate& candidate : candidates) known.insert(key(candidate.T_map_base));
  for (const Candidate& candidate : more) {
    if (known.insert(key(candidate.T_map_base)).second) candidates.push_back(candidate);
  }
}

}  // namespace

std::vector<Candidate> search_map(const CreateContext& context, const CascadeMatcher& matcher,
                                  const ScanPoints& points, const std::optional<int>& most) {
  const CreateConfig& config = context.config;
  std::vector<Candidate> candidates = matcher.match(points, {}, most);
  if (config.far_share > 0.0) {
    join(matcher.match(farthest(points, config.far_share), {}, most), candidates);
  }
  if (candidates.size() > static_cast<std::size_t>(config.looked_at)) {
    screen(context.evidence, thinned(points, kGlance), config.looked_at, candidates);
  }
  screen(context.evidence, points, config.refined, candidates);
  return candidates;
}

std::vector<WeighedPlace> refine_candidates(const CreateContext& context,
                                            const std::vector<Candidate>& candidates,
                                            const ScanPoints& points) {
  std::vector<WeighedPlace> places;
  for (const Candidate& candidate : candidates) {
    const SE2 pose = refine_pose(context.model, points, candidate.T_map_base, std::nullopt,
                                 context.config.refine);
    places.push_back({pose, context.evidence.evaluate(points, pose), 0.0});
  }
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return a.newest.log_likelihood > b.newest.log_likelihood;
  });
  std::vector<WeighedPlace> distinct;
  for (const WeighedPlace& place : places) {
    if (distinct.size() == static_cast<std::size_t>(context.config.keep)) break;
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const auto& other) {
      return same_place(context.merge, place.T_map_base, other.T_map_base);
    });
    if (!known) distinct.push_back(place);
  }
  return distinct;
}

std::vector<WeighedPlace> find_places(const CreateContext& context, const CascadeMatcher& matcher,
                                      const ScanPoints& points) {
  auto places = refine_candidates(context, search_map(context, matcher, points), points);
  if (places.empty() || places[0].newest.log_likelihood >= context.config.deep_below) return places;
  return refine_candidates(
      context, search_map(context, matcher, points, context.config.deep_candidates), points);
}

double weigh_backwards(const CreateContext& context, const ScanHistory& history,
                       const WeighedPlace& place) {
  assert(!history.empty());
  double best = -std::numeric_limits<double>::infinity();
  double increments = 0.0;  // of the scans after the one at hand
  SE2 pose = place.T_map_base;
  double l = place.newest.log_likelihood;
  for (std::size_t k = history.size(); k-- > 0;) {
    const ScanMemory& scan = history[k];
    const double origin = log_sum_exp({scan.listed_before + scan.kidnap_cue, scan.unlisted_before});
    best = std::max(best, origin + context.posterior.place + l + increments);
    if (k == 0) break;
    pose = step_back(context, pose, scan, history[k - 1]);
    const double earlier = context.evidence.evaluate(history[k - 1].points, pose).log_likelihood;
    increments += l - (1.0 - scan.independence) * earlier;
    l = earlier;
  }
  return best;
}

}  // namespace castaway::localization
