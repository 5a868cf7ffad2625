#include "localization/hypotheses/create.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

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

/// The best candidates by evidence, taken at their coarse pose; its score becomes the candidate's.
void screen(const CreateContext& context, const ScanPoints& points,
            std::vector<Candidate>& candidates) {
  for (Candidate& candidate : candidates) {
    candidate.score = context.evidence.evaluate(points, candidate.T_map_base).log_likelihood;
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  const auto most = static_cast<std::size_t>(context.config.refined);
  if (candidates.size() > most) {
    candidates.erase(candidates.begin() + context.config.refined, candidates.end());
  }
}

}  // namespace

std::vector<Candidate> search_map(const CreateContext& context, const CascadeMatcher& matcher,
                                  const ScanPoints& points) {
  std::vector<Candidate> candidates = matcher.match(points);
  if (context.config.far_share > 0.0) {
    for (const Candidate& far : matcher.match(farthest(points, context.config.far_share))) {
      const bool known = std::any_of(
          candidates.begin(), candidates.end(),
          [&](const Candidate& candidate) { return candidate.T_map_base == far.T_map_base; });
      if (!known) candidates.push_back(far);
    }
  }
  screen(context, points, candidates);
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
