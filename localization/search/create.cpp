#include "localization/search/create.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace castaway::localization {
namespace {

/// Of the model of refinement.
PoseClimber wide_climber(const CreateContext& context) {
  return {context.model, context.ndt != nullptr ? &context.ndt->wide : nullptr};
}

/// Of the sharper model of the evidence.
PoseClimber sharp_climber(const CreateContext& context) {
  return {context.evidence.endpoint(), context.ndt != nullptr ? &context.ndt->sharp : nullptr};
}

/// The pose at the previous scan: predicted by odometry, and refined within its noise.
SE2 step_back(const CreateContext& context, const SE2& T_map_base, const ScanMemory& later,
              const ScanMemory& earlier) {
  const SE2 u = later.T_odom_base.inverse() * earlier.T_odom_base;
  SE2 predicted = T_map_base * u;
  if (context.volume != nullptr) predicted = context.volume->atlas().on_own_chart(predicted);
  const OdometryMotion motion(u, context.noise);
  const Eigen::Matrix3d slack = Eigen::Vector3d(1e-4, 1e-4, 1e-5).asDiagonal();
  const Eigen::Matrix3d spread = rotate_to_map(motion.covariance(), T_map_base.yaw) + slack;
  return wide_climber(context).climb(earlier.points, predicted,
                                     PosePrior{predicted, spread.inverse()},
                                     context.config.refine_back);
}

/// True if a hypothesis is at the place and fits the newest scan about as well.
bool is_listed(const MergeConfig& config, const std::vector<Hypothesis>& hypotheses,
               const WeighedPlace& place) {
  return std::any_of(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& h) {
    return same_place(config, h.belief.mean, place.T_map_base) &&
           h.log_likelihood > place.newest.log_likelihood - 1.0;
  });
}

/// Log-weight of a place by the scans before a scan, if the robot arrived there just before it.
struct Arrival {
  double fitting = 0.0;  ///< If the scan fits at the place.
  double other = 0.0;    ///< Otherwise.
};

/// The arrivals before each scan of the history.
std::vector<Arrival> arrivals(const CreateContext& context, const ScanHistory& history) {
  std::vector<Arrival> all;
  for (const ScanMemory& scan : history) {
    const double place = context.posterior.place + std::log(scan.periods);
    const auto weight = [&](double cue) {
      return log_sum_exp({scan.listed_before + cue, scan.null_before}) + place;
    };
    all.push_back({weight(std::max(scan.arrival_cue, 0.0)), weight(scan.kidnap_cue)});
  }
  return all;
}

/// The highest weight of an arrival before one of the first `count` scans.
double best_arrival(const std::vector<Arrival>& all, std::size_t count) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count; ++k) best = std::max(best, all[k].fitting);
  return best;
}

/// Moves candidates to where a few beams fit best.
void settle(const CreateContext& context, const ScanPoints& points,
            std::vector<Candidate>& candidates) {
  const ScanPoints few = thin(points, context.config.settled_beams);
  for (Candidate& c : candidates) {
    c.T_map_base =
        refine_pose(context.model, few, c.T_map_base, std::nullopt, context.config.settle);
  }
}

constexpr int kGlance = 24;  // Beams that screen long lists.

bool has_better_score(const Candidate& a, const Candidate& b) { return a.score > b.score; }

/// Keeps the best `most` candidates by the evidence of their coarse pose, which becomes their
/// score. They are evaluated in the order of their upper bounds, so that most of a long list needs
/// no rays.
void screen(const EvidenceModel& evidence, const ScanPoints& points, int most,
            std::vector<Candidate>& candidates) {
  for (Candidate& c : candidates) c.score = evidence.bound(points, c.T_map_base);
  std::stable_sort(candidates.begin(), candidates.end(), has_better_score);
  std::priority_queue<double, std::vector<double>, std::greater<>> kept;  // The worst on top.
  const auto count = static_cast<std::size_t>(most);
  auto end = candidates.begin();
  for (; end != candidates.end(); ++end) {
    const bool full = kept.size() == count;
    const double least = full ? kept.top() : -std::numeric_limits<double>::infinity();
    if (end->score <= least) break;
    end->score = evidence.log_likelihood_above(least, points, end->T_map_base);
    kept.push(end->score);
    if (kept.size() > count) kept.pop();
  }
  std::stable_sort(candidates.begin(), end, has_better_score);
  candidates.resize(kept.size());
}

}  // namespace

std::vector<Candidate> screen_candidates(const CreateContext& context,
                                         std::vector<Candidate> candidates,
                                         const ScanPoints& points, int most) {
  const CreateConfig& config = context.config;
  if (config.settled_beams > 0) settle(context, points, candidates);
  if (candidates.size() > static_cast<std::size_t>(config.looked_at)) {
    screen(context.evidence, thin(points, kGlance), config.looked_at, candidates);
  }
  screen(context.evidence, points, most, candidates);
  const double least = candidates.empty() ? 0.0 : candidates.front().score - config.refined_behind;
  std::erase_if(candidates, [&](const Candidate& c) { return c.score < least; });
  return candidates;
}

std::vector<WeighedPlace> refine_candidates(const CreateContext& context,
                                            const std::vector<Candidate>& candidates,
                                            const ScanPoints& points) {
  std::vector<WeighedPlace> places;
  for (const Candidate& candidate : candidates) {
    const SE2 near = wide_climber(context).climb(points, candidate.T_map_base, std::nullopt,
                                                 context.config.refine);
    const SE2 pose =
        sharp_climber(context).climb(points, near, std::nullopt, context.config.refine_last);
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

bool is_unclear(const CreateConfig& config, const std::vector<WeighedPlace>& places) {
  return places.empty() || places.front().newest.log_likelihood < config.deep_below;
}

int deep_candidates(const CreateConfig& config, const std::vector<WeighedPlace>& places,
                    int before) {
  constexpr double kAgain = 4.0;
  constexpr double kMostAtFirst = 6.0;
  if (!is_unclear(config, places)) return 0;
  if (places.empty()) return config.deep_candidates;
  const double misfit = config.deep_below - places.front().newest.log_likelihood;
  const double growth = std::min(std::exp(config.deep_growth * misfit), kMostAtFirst);
  const double wanted = std::max(config.first_deep * growth, kAgain * before);
  return static_cast<int>(std::min<double>(wanted, config.deep_candidates));
}

BestFound best_of(const std::vector<WeighedPlace>& places) {
  const Evidence& first = places.front().newest;
  const double lead = places.size() > 1 ? first.log_likelihood - places[1].newest.log_likelihood
                                        : std::numeric_limits<double>::infinity();
  return {first.log_likelihood, lead};
}

double weigh_backwards(const CreateContext& context, const ScanHistory& history,
                       const WeighedPlace& place, double least) {
  assert(!history.empty());
  const std::vector<Arrival> all = arrivals(context, history);
  double best = -std::numeric_limits<double>::infinity();
  double increments = 0.0;  // Evidence of the scans after scan k.
  SE2 pose = place.T_map_base;
  double l = place.newest.log_likelihood;
  for (std::size_t k = history.size(); k-- > 0;) {
    const ScanMemory& scan = history[k];
    const double arrival = l >= scan.unlisted ? all[k].fitting : all[k].other;
    best = std::max(best, arrival + l + increments);
    if (k == 0) break;
    const double wanted = std::max(best, least) - best_arrival(all, k) - l - increments;
    if (wanted >= 0.0) break;
    pose = step_back(context, pose, scan, history[k - 1]);
    // The weight grows by the independent share of the earlier scan's log-likelihood.
    const double limit = wanted / std::max(scan.independence, 1e-9);
    const double earlier =
        context.evidence.log_likelihood_above(limit, history[k - 1].points, pose);
    if (earlier <= limit) break;
    increments += l - (1.0 - scan.independence) * earlier;
    l = earlier;
  }
  return best;
}

std::vector<WeighedPlace> new_places(const CreateContext& context, const ScanHistory& history,
                                     const std::vector<Hypothesis>& hypotheses, double behind,
                                     const std::vector<WeighedPlace>& places) {
  std::vector<WeighedPlace> listed;
  double best = listed_log_weight(hypotheses);
  for (WeighedPlace place : places) {
    if (is_listed(context.merge, hypotheses, place)) continue;
    place.log_weight = weigh_backwards(context, history, place, best - behind);
    if (place.log_weight < best - behind) continue;
    best = std::max(best, place.log_weight);
    listed.push_back(place);
  }
  return listed;
}

}  // namespace castaway::localization
