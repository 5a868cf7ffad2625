#include "tools/run/metrics/ape.hpp"

#include <algorithm>
#include <cmath>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

/// Index of the pose nearest in time, the earlier of two.
std::size_t nearest(const std::vector<StampedPose>& poses, std::chrono::nanoseconds stamp) {
  const auto after = std::lower_bound(
      poses.begin(), poses.end(), stamp,
      [](const StampedPose& pose, std::chrono::nanoseconds s) { return pose.stamp < s; });
  if (after == poses.begin()) return 0;
  const auto before = std::prev(after);
  const bool earlier = after == poses.end() || stamp - before->stamp <= after->stamp - stamp;
  return static_cast<std::size_t>((earlier ? before : after) - poses.begin());
}

Ape figures(const std::vector<double>& errors) {
  const Statistics sample = *statistics(errors);
  double squares = 0.0;
  for (const double error : errors) squares += (error - sample.mean) * (error - sample.mean);
  return {errors.size(),
          sample.max,
          sample.mean,
          sample.median,
          *std::min_element(errors.begin(), errors.end()),
          sample.rmse,
          std::sqrt(squares / static_cast<double>(errors.size()))};
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> matched_by_time(
    const std::vector<StampedPose>& a, const std::vector<StampedPose>& b,
    std::chrono::nanoseconds max_apart) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const bool a_is_short = a.size() < b.size();
  const auto& few = a_is_short ? a : b;
  const auto& many = a_is_short ? b : a;
  for (std::size_t i = 0; i < few.size() && !many.empty(); ++i) {
    const std::size_t k = nearest(many, few[i].stamp);
    if (std::chrono::abs(many[k].stamp - few[i].stamp) > max_apart) continue;
    pairs.emplace_back(a_is_short ? i : k, a_is_short ? k : i);
  }
  return pairs;
}

std::optional<Ape> absolute_pose_error(const std::vector<StampedPose>& truth,
                                       const std::vector<StampedPose>& estimate) {
  std::vector<double> errors;
  for (const auto& [i, k] : matched_by_time(truth, estimate)) {
    errors.push_back(localization::distance(truth[i].T_map_base, estimate[k].T_map_base));
  }
  if (errors.empty()) return std::nullopt;
  return figures(errors);
}

}  // namespace castaway::testbed
