#include "localization/search/rescue.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::localization {

bool is_on_way(const SE2& centre, const SE2& step, double beside, const SE2& T_map_base) {
  constexpr double kTurn = 0.1;
  constexpr double kSteps = 2.0;   // The stamps of both scans jitter by up to a period.
  constexpr double kBeside = 0.3;  // Of the step.
  const SE2 place = centre.inverse() * T_map_base;
  if (std::abs(place.yaw) > kSteps * std::abs(step.yaw) + kTurn) return false;
  const Eigen::Vector2d way = step.translation();
  const double length2 = std::max(way.squaredNorm(), 1e-12);
  const double along = std::clamp(place.translation().dot(way) / length2, -kSteps, kSteps);
  return (place.translation() - along * way).norm() <= beside + kBeside * way.norm();
}

std::optional<SE2> best_on_way(const EndpointModel& model, const ScanPoints& points,
                               const SE2& centre, const SE2& step, double spacing) {
  constexpr double kSteps = 1.5;  // Before and behind the pose.
  constexpr double kMost = 50.0;  // Poses before and behind it, however long the step.
  const double size = std::max(step.translation().norm(), std::abs(step.yaw));
  const int count = static_cast<int>(std::min(std::ceil(kSteps * size / spacing), kMost));
  std::optional<SE2> best;
  double highest = model.log_likelihood(points, centre);
  for (int k = -count; k <= count; ++k) {
    const SE2 pose = centre * interpolate(SE2{}, step, kSteps * k / std::max(count, 1));
    const double l = model.log_likelihood(points, pose);
    if (l <= highest) continue;
    highest = l;
    best = pose;
  }
  return best;
}

std::vector<Candidate> Rescue::candidates(const CreateContext& context, const SE2& centre,
                                          double below_usual, const ScanPoints& points,
                                          const LastStep& step) const {
  std::vector<Candidate> found;
  const bool sparse = step.periods >= config_.sparse_periods;
  if (sparse || below_usual > config_.drop / std::max(step.periods, 1.0)) {
    const double yaw_radius = config_.yaw_radius + std::abs(step.u.yaw);
    found = matcher_.match(points, MatchWindow{centre, config_.radius, yaw_radius});
    found.resize(std::min(found.size(), static_cast<std::size_t>(config_.candidates)));
  }
  constexpr int kBeams = 45;
  const double size = std::max(step.u.translation().norm(), std::abs(step.u.yaw));
  if (size < config_.long_step) return found;
  if (below_usual <= 0.0) return found;
  const auto place =
      best_on_way(context.model, thin(points, kBeams), centre, step.u, config_.spacing);
  if (place) found.push_back({*place, 1.0});
  return found;
}

std::vector<WeighedPlace> Rescue::refine(const CreateContext& context,
                                         std::vector<Candidate> candidates, double now,
                                         const ScanPoints& points) const {
  const double least = now - config_.refined_behind;
  std::erase_if(candidates, [&](const Candidate& c) {
    return context.evidence.log_likelihood_above(least, points, c.T_map_base) <= least;
  });
  return refine_candidates(context, candidates, points);
}

std::optional<WeighedPlace> Rescue::find(const CreateContext& context, const Hypothesis& output,
                                         double usual, const ScanPoints& points,
                                         const LastStep& step) const {
  const SE2& centre = output.belief.mean;
  const double now = context.evidence.evaluate(points, centre).log_likelihood;
  if (now > -config_.gain) return std::nullopt;
  const std::vector<WeighedPlace> places =
      refine(context, candidates(context, centre, usual - now, points, step), now, points);
  if (places.empty() || places[0].newest.log_likelihood < now + config_.gain) return std::nullopt;
  const Evidence before{output.log_likelihood, output.quality};
  const SE2& place = places[0].T_map_base;
  return WeighedPlace{place, before, output.log_weight - cost_of(centre, place, usual - now, step)};
}

/// [nats] Of a slip or of jitter that moved the output from `centre` to `place`.
double Rescue::cost_of(const SE2& centre, const SE2& place, double below_usual,
                       const LastStep& step) const {
  if (is_on_way(centre, step.u, config_.beside_way, place)) {
    return below_usual > config_.drop ? config_.cost_on_way : config_.cost_on_way_unnoticed;
  }
  const double share = std::max(distance(centre, place) / config_.radius,
                                yaw_distance(centre, place) / config_.yaw_radius);
  const double slip = config_.cost_near + std::min(share, 1.0) * (config_.cost - config_.cost_near);
  return std::max(config_.cost_on_way, slip - std::log(step.periods));
}

bool Rescue::reaches(const SE2& output, const SE2& place) const {
  return distance(output, place) < config_.radius &&
         yaw_distance(output, place) < config_.yaw_radius;
}

}  // namespace castaway::localization
