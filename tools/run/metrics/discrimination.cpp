#include "tools/run/metrics/discrimination.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

/// Number of right and of wrong outputs.
std::pair<std::int64_t, std::int64_t> right_and_wrong(const std::vector<ScoredOutput>& outputs) {
  const auto right = std::count_if(outputs.begin(), outputs.end(),
                                   [](const ScoredOutput& output) { return output.right; });
  return {right, static_cast<std::int64_t>(outputs.size()) - right};
}

/// End of the run of equal scores that starts at `begin`.
std::size_t end_of_ties(const std::vector<ScoredOutput>& descending, std::size_t begin) {
  std::size_t end = begin;
  while (end < descending.size() && descending[end].score == descending[begin].score) ++end;
  return end;
}

}  // namespace

std::vector<std::pair<double, double>> roc_curve(std::vector<ScoredOutput> outputs) {
  const auto [right, wrong] = right_and_wrong(outputs);
  if (right == 0 || wrong == 0) return {};
  std::sort(outputs.begin(), outputs.end(),
            [](const ScoredOutput& a, const ScoredOutput& b) { return a.score > b.score; });
  std::vector<std::pair<double, double>> curve{{0.0, 0.0}};
  std::int64_t passed_right = 0;
  std::int64_t passed_wrong = 0;
  for (std::size_t i = 0; i < outputs.size();) {
    const std::size_t end = end_of_ties(outputs, i);
    for (; i < end; ++i) ++(outputs[i].right ? passed_right : passed_wrong);
    curve.emplace_back(static_cast<double>(passed_wrong) / static_cast<double>(wrong),
                       static_cast<double>(passed_right) / static_cast<double>(right));
  }
  return curve;
}

/// Sums trapezoids under the curve. A tie is a diagonal segment, so its pairs count half.
std::optional<double> roc_area(std::vector<ScoredOutput> outputs) {
  const auto curve = roc_curve(std::move(outputs));
  if (curve.empty()) return std::nullopt;
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    area += 0.5 * (curve[i].first - curve[i - 1].first) * (curve[i].second + curve[i - 1].second);
  }
  return area;
}

std::optional<double> correlation(const std::vector<std::pair<double, double>>& pairs) {
  const auto count = static_cast<double>(pairs.size());
  double mean_a = 0.0;
  double mean_b = 0.0;
  for (const auto& [a, b] : pairs) {
    mean_a += a / count;
    mean_b += b / count;
  }
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (const auto& [a, b] : pairs) {
    aa += (a - mean_a) * (a - mean_a);
    bb += (b - mean_b) * (b - mean_b);
    ab += (a - mean_a) * (b - mean_b);
  }
  if (aa <= 0.0 || bb <= 0.0) return std::nullopt;
  return ab / std::sqrt(aa * bb);
}

Discrimination discrimination_of(const std::vector<MetricRow>& rows) {
  std::vector<ScoredOutput> quality;
  std::vector<ScoredOutput> probability;
  std::vector<ScoredOutput> covariance;
  for (const MetricRow& row : rows) {
    const auto error = pose_error(row);
    if (!error) continue;
    const bool right = error->position_m < kWrongFrom;
    if (!std::isnan(row.quality)) quality.push_back({row.quality, right});
    if (!std::isnan(row.probability)) probability.push_back({row.probability, right});
    covariance.push_back({-row.sigma_m, right});
  }
  const auto [right, wrong] = right_and_wrong(covariance);
  return {right, wrong, roc_area(std::move(quality)), roc_area(std::move(probability)),
          roc_area(std::move(covariance))};
}

}  // namespace castaway::testbed
