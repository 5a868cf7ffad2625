#include "tools/twin/fits/figure.hpp"

#include <cmath>

namespace castaway::testbed {

Figure widen(const Figure& figure, double sigma) {
  constexpr double kNormal = 1.96;
  const double below = std::hypot(figure.value - figure.interval.low, kNormal * sigma);
  const double above = std::hypot(figure.interval.high - figure.value, kNormal * sigma);
  return {figure.value, {figure.value - below, figure.value + above}};
}

std::vector<Figure> jackknife(const BlockFit& fit) {
  constexpr double kQuantile = 2.201;  // Of Student's t with 11 degrees of freedom, 97.5 %.
  static_assert(Blocks::kCount == 12);
  const std::vector<double> whole = fit(Blocks::kCount);
  std::vector<std::vector<double>> parts;
  for (std::size_t block = 0; block < Blocks::kCount; ++block) parts.push_back(fit(block));
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    double mean = 0.0;
    for (const auto& part : parts) mean += part[k] / Blocks::kCount;
    double squares = 0.0;
    for (const auto& part : parts) squares += (part[k] - mean) * (part[k] - mean);
    const double sigma = std::sqrt(squares * (Blocks::kCount - 1.0) / Blocks::kCount);
    figures.push_back({whole[k], {whole[k] - kQuantile * sigma, whole[k] + kQuantile * sigma}});
  }
  return figures;
}

}  // namespace castaway::testbed
