#include "tools/twin/fits/beam_bias_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr std::size_t kBiasBeams = 7;  // In a group.
constexpr double kLeastMove = 0.05;    // [m] Between two scans that count,
constexpr double kLeastTurn = 0.05;    // [rad] or this.
/// Variance of the middle one of seven residuals from a line, by that of the offsets.
constexpr double kMiddleShare = 6.0 / 7.0;
constexpr double kFewestBiasSamples = 10.0;  // Of a beam in a part of the log.

/// How far a beam lies beside the line through its neighbours and itself.
struct BiasSample {
  std::size_t beam = 0;
  std::size_t part = 0;   ///< Of the log.
  double residual = 0.0;  ///< [m]
};

/// Residual of the middle beam of a group: 1 / r is linear in cosine and sine on a line, and errors
/// are weighted by 1 / r.
double middle_residual(const LaserScan& scan, std::size_t first) {
  const std::size_t middle = first + kBiasBeams / 2;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t k = first; k < first + kBiasBeams; ++k) {
    const double angle = scan.beam_angle(k) - scan.beam_angle(middle);
    const double px = scan.ranges[k] * std::cos(angle);
    const double py = scan.ranges[k] * std::sin(angle);
    x += px;
    y += py;
    xx += px * px;
    xy += px * py;
    yy += py * py;
  }
  const double inverse_range = (x * yy - y * xy) / (xx * yy - xy * xy);
  const double r = scan.ranges[middle];
  return r * (r * inverse_range - 1.0);
}

bool returns_near_last(const LaserScan& scan, std::size_t i) {
  constexpr double kNearLast = 0.25;  // [m]
  const double r = scan.ranges[i];
  const bool measured = std::isfinite(r) && r > scan.range_min && r < scan.range_max;
  return measured && (i == 0 || std::abs(r - scan.ranges[i - 1]) < kNearLast);
}

void add_bias_samples(const LaserScan& scan, std::size_t part, std::vector<BiasSample>& samples) {
  constexpr double kOffLine = 0.1;  // [m] A larger residual is that of a corner.
  std::size_t run = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    run = returns_near_last(scan, i) ? run + 1 : 0;
    if (run < kBiasBeams) continue;
    const std::size_t first = i + 1 - kBiasBeams;
    const double residual = middle_residual(scan, first);
    if (!(std::abs(residual) < kOffLine)) continue;
    samples.push_back({first + kBiasBeams / 2, part, residual});
  }
}

std::vector<BiasSample> take_bias_samples(const AlignedLog& log) {
  std::vector<BiasSample> samples;
  const AlignedScan* last = nullptr;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    const AlignedScan& aligned = log.scans[i];
    const bool stands =
        last && localization::distance(aligned.T_map_base, last->T_map_base) < kLeastMove &&
        localization::yaw_distance(aligned.T_map_base, last->T_map_base) < kLeastTurn;
    if (stands) continue;
    last = &aligned;
    add_bias_samples(aligned.scan, i * Blocks::kCount / log.scans.size(), samples);
  }
  return samples;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Drops samples that lie implausibly far from the median of their beam: surfaces that are not
/// flat. About 0 instead of that median, large offsets would be dropped, too.
void drop_rough(std::size_t beams, std::vector<BiasSample>& samples) {
  constexpr double kRough = 4.0;  // Times the median distance.
  if (samples.empty()) return;
  std::vector<std::vector<double>> by_beam(beams);
  for (const BiasSample& s : samples) by_beam[s.beam].push_back(s.residual);
  std::vector<double> medians;
  for (const auto& residuals : by_beam) {
    medians.push_back(residuals.empty() ? 0.0 : median_of(residuals));
  }
  std::vector<double> sizes;
  for (const BiasSample& s : samples) sizes.push_back(std::abs(s.residual - medians[s.beam]));
  const double most = kRough * median_of(std::move(sizes));
  std::erase_if(samples,
                [&](const BiasSample& s) { return std::abs(s.residual - medians[s.beam]) > most; });
}

/// Residuals of one beam in one part of the log.
struct BiasMean {
  double sum = 0.0;
  double count = 0.0;
};

/// Those of one beam by part.
using BiasMeans = std::array<BiasMean, Blocks::kCount>;

/// The means of all beams; those of a part sum up to 0, because an offset that all beams share is
/// not one of single beams.
std::vector<BiasMeans> mean_residuals(std::size_t beams, const std::vector<BiasSample>& samples) {
  BiasMeans all{};
  for (const BiasSample& s : samples) {
    all[s.part].sum += s.residual;
    all[s.part].count += 1.0;
  }
  std::vector<BiasMeans> means(beams);
  for (const BiasSample& s : samples) {
    means[s.beam][s.part].sum += s.residual - all[s.part].sum / all[s.part].count;
    means[s.beam][s.part].count += 1.0;
  }
  return means;
}

/// Products of the means of the same beam in two parts.
struct BiasProducts {
  double sum = 0.0;
  double count = 0.0;
  std::size_t beams = 0;

  [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

BiasProducts multiply_parts(const std::vector<BiasMeans>& beams, std::size_t left_out) {
  BiasProducts products;
  for (const BiasMeans& means : beams) {
    double sum = 0.0, squares = 0.0, parts = 0.0;
    for (std::size_t part = 0; part < Blocks::kCount; ++part) {
      if (part == left_out || means[part].count < kFewestBiasSamples) continue;
      const double mean = means[part].sum / means[part].count;
      sum += mean;
      squares += mean * mean;
      parts += 1.0;
    }
    products.sum += 0.5 * (sum * sum - squares);
    products.count += 0.5 * parts * (parts - 1.0);
    products.beams += parts > 1.0 ? 1 : 0;
  }
  return products;
}

double bias_sigma(double covariance) { return std::sqrt(std::max(covariance, 0.0) / kMiddleShare); }

/// Sets the means of the beams beside what the fitted offsets let expect.
void describe(const std::vector<BiasMeans>& beams, BeamBiasFit& fit) {
  double variances = 0.0;  // Of the means by noise, as their parts differ.
  for (const BiasMeans& means : beams) {
    double sum = 0.0, squares = 0.0, parts = 0.0;
    for (const BiasMean& part : means) {
      if (part.count < kFewestBiasSamples) continue;
      const double mean = part.sum / part.count;
      sum += mean;
      squares += mean * mean;
      parts += 1.0;
    }
    if (parts < 2.0) continue;
    fit.means_m.push_back(sum / parts);
    variances += std::max(squares - sum * sum / parts, 0.0) / (parts * (parts - 1.0));
  }
  std::sort(fit.means_m.begin(), fit.means_m.end());
  const auto count = static_cast<double>(std::max<std::size_t>(fit.means_m.size(), 1));
  fit.means_sigma_m =
      std::sqrt(kMiddleShare * fit.sigma_m.value * fit.sigma_m.value + variances / count);
}

}  // namespace

std::optional<BeamBiasFit> fit_beam_bias(const AlignedLog& log) {
  constexpr double kFewestProducts = 200.0;
  std::vector<BiasSample> samples = take_bias_samples(log);
  std::size_t beams = 0;
  for (const BiasSample& s : samples) beams = std::max(beams, s.beam + 1);
  drop_rough(beams, samples);
  const std::vector<BiasMeans> means = mean_residuals(beams, samples);
  const BiasProducts all = multiply_parts(means, Blocks::kCount);
  if (all.count < kFewestProducts) return std::nullopt;
  const Figure covariance = jackknife([&](std::size_t left_out) {
                              return std::vector{multiply_parts(means, left_out).mean()};
                            }).front();
  const Figure sigma{bias_sigma(covariance.value),
                     {bias_sigma(covariance.interval.low), bias_sigma(covariance.interval.high)}};
  BeamBiasFit fit;
  fit.beams = all.beams;
  // The beams are a sample of the offsets; no part of the log shows others. Residuals of
  // neighbours are correlated: 1.29 is the sum of their squared correlations.
  const double sampling = std::sqrt(1.29 / 2.0 / static_cast<double>(all.beams));
  constexpr double kModel = 5e-4;  // [m] Surfaces are not quite flat, and ranges are rounded.
  fit.sigma_m = widen(sigma, std::hypot(sampling * sigma.value, kModel));
  fit.sigma_m.interval.low = std::max(fit.sigma_m.interval.low, 0.0);
  describe(means, fit);
  return fit;
}

}  // namespace castaway::testbed
