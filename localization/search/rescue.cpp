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

std::optional<WeighedPlace> Rescue::find(const CreateContext& context, const Hypothesis& output,
                                         double usual, const ScanPoints& points,
                                         const SE2& step) const {
  const SE2& centre = output.belief.mean;
  const double now = context.evidence.evaluate(points, centre).log_likelihood;
  if (now > usual - config_.drop) return std::nullopt;
  const MatchWindow window{centre, config_.radius, config_.yaw_radius};
  std::vector<Candidate> candidates = matcher_.match(points, window);
  candidates.resize(std::min(candidates.size(), static_cast<std::size_t>(config_.candidates)));
  const std::vector<WeighedPlace> places = refine_candidates(context, candidates, points);
  if (places.empty() || places[0].newest.log_likelihood < now + config_.gain) return std::nullopt;
  const Evidence before{output.log_likelihood, output.quality};
  const SE2& place = places[0].T_map_base;
  const bool on_way = is_on_way(centre, step, config_.beside_way, place);
  const double cost = on_way ? config_.cost_on_way : config_.cost;
  return WeighedPlace{place, before, output.log_weight - cost};
}

bool Rescue::reaches(const SE2& output, const SE2& place) const {
  return distance(output, place) < config_.radius &&
         yaw_distance(output, place) < config_.yaw_radius;
}

}  // namespace castaway::localization
