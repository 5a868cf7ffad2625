#include "tools/twin/fits/odometry_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace castaway::testbed {
namespace {

constexpr double kShort = 1.0;  // [m] Lengths of stretches.
constexpr double kLong = 4.0;
constexpr double kOutlier = 4.0;      // Standard deviations.
constexpr double kDriftModel = 0.06;  // Standard deviation of a drift by the model; relative.

/// Successive legs.
struct Stretch {
  std::vector<OdometryStep> steps;
  SE2 T_start_end;
  double way = 0.0;  ///< [m]
  /// [m] Travel whose errors move the end along x and y of its frame.
  Eigen::Vector2d walk{0.0, 0.0};
  Eigen::Vector2d sway{0.0, 0.0};  ///< [m^3] The same for errors of the yaw.
  std::size_t leg = 0;             ///< Index of the first leg.
};

/// Sets `walk` and `sway`: travel of the wheels, weighted by the squares of how far an error of the
/// distance or of the yaw there moves the end.
void weigh_travel(Stretch& stretch) {
  const SE2 end = correct_motion(stretch.steps, {});
  SE2 pose;
  for (const OdometryStep& step : stretch.steps) {
    pose = pose * correct_motion({step}, {});
    const SE2 T_end_step = end.inverse() * pose;
    const Eigen::Vector2d heading(std::cos(T_end_step.yaw), std::sin(T_end_step.yaw));
    const Eigen::Vector2d lever(T_end_step.y, T_end_step.x);
    stretch.walk += step.way * heading.cwiseAbs2();
    stretch.sway += step.way * lever.cwiseAbs2();
  }
}

std::vector<Stretch> take_stretches(const std::vector<Leg>& legs, double length) {
  std::vector<Stretch> stretches;
  Stretch now;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].breaks) {
      now = {};
      continue;
    }
    if (now.steps.empty()) now.leg = i;
    now.steps.insert(now.steps.end(), legs[i].steps.begin(), legs[i].steps.end());
    now.T_start_end = now.T_start_end * legs[i].T_start_end;
    now.way += legs[i].way;
    if (now.way < length) continue;
    if (now.way < 3.0 * length) {
      weigh_travel(now);
      stretches.push_back(std::move(now));
    }
    now = {};
  }
  return stretches;
}

/// Errors of corrected odometry at the end of a stretch.
struct Miss {
  double along = 0.0;   ///< [m]
  double across = 0.0;  ///< [m]
  double yaw = 0.0;     ///< [rad]
};

Miss miss_of(const Stretch& stretch, const OdometryErrors& errors) {
  const SE2 e = stretch.T_start_end.inverse() * correct_motion(stretch.steps, errors);
  return {e.x, e.y, e.yaw};
}

/// Variances that add up to that of a miss: per metre, and of the alignment at both ends.
struct Components {
  double per_m = 0.0;
  double match = 0.0;  ///< Of one end.
};

struct Noise {
  Components along{4e-4, 2e-4};  // [m^2/m], [m^2]
  Components yaw{4e-4, 4e-5};    // [rad^2/m], [rad^2]

  [[nodiscard]] double along_variance(const Stretch& s) const {
    return along.per_m * s.walk.x() + yaw.per_m * s.sway.x() + 2.0 * along.match;
  }
  [[nodiscard]] double yaw_variance(const Stretch& s) const {
    return yaw.per_m * s.way + 2.0 * yaw.match;
  }
};

/// Weight of a residual by Huber's function.
double huber(double normalized) {
  constexpr double kBend = 2.0;
  return std::min(1.0, kBend / std::max(std::abs(normalized), 1e-9));
}

using Parameters = Eigen::Vector3d;  // scale, yaw_scale, curvature

OdometryErrors to_errors(const Parameters& p, double track) {
  return errors_of(p(0), p(1), p(2), track);
}

/// One Gauss-Newton step of the weighted least squares.
Parameters improve(const std::vector<Stretch>& stretches, const Noise& noise, const Parameters& p,
                   double track) {
  constexpr double kStep = 1e-5;
  constexpr double kUsual = 0.1;  // Size of usual errors, for paths that cannot tell them apart.
  Eigen::Matrix3d H = Eigen::Matrix3d::Identity() / (kUsual * kUsual);
  Eigen::Vector3d g = p / (kUsual * kUsual);
  for (const Stretch& s : stretches) {
    const Miss miss = miss_of(s, to_errors(p, track));
    Eigen::Matrix<double, 2, 3> J;
    for (int k = 0; k < 3; ++k) {
      const Miss moved = miss_of(s, to_errors(p + kStep * Parameters::Unit(k), track));
      J.col(k) << (moved.along - miss.along) / kStep, (moved.yaw - miss.yaw) / kStep;
    }
    const Eigen::Vector2d r(miss.along, miss.yaw);
    const Eigen::Vector2d sigma(std::sqrt(noise.along_variance(s)),
                                std::sqrt(noise.yaw_variance(s)));
    for (int row = 0; row < 2; ++row) {
      const double weight = huber(r(row) / sigma(row)) / (sigma(row) * sigma(row));
      H += weight * J.row(row).transpose() * J.row(row);
      g += weight * J.row(row).transpose() * r(row);
    }
  }
  return p - H.ldlt().solve(g);
}

/// A squared miss with its travel, and the part of its variance that is known otherwise.
struct Square {
  double value = 0.0;
  double way = 0.0;
  double known = 0.0;
};

/// Estimates variance components by iterated weighted least squares of the squares, which is
/// maximum likelihood for normal misses. Outliers are left out, and squares that are mostly known
/// otherwise: they say more about that than about the components.
Components fit_components(const std::vector<Square>& squares, Components at) {
  constexpr double kTrim = 2.5;       // Standard deviations.
  constexpr double kUntrim = 1.0974;  // Makes up for the tails of normal misses beyond.
  constexpr int kWide = 6;            // Rounds without the trim: the first variance may be small.
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (const Square& s : squares) {
      const double variance = at.per_m * s.way + 2.0 * at.match + s.known;
      const bool is_trimmed = round >= kWide && s.value > kTrim * kTrim * variance;
      if (is_trimmed || 2.0 * s.known > variance) continue;
      const Eigen::Vector2d row(s.way, 2.0);
      A += row * row.transpose() / (variance * variance);
      const double value = round >= kWide ? kUntrim * s.value : s.value;
      b += row * (value - s.known) / (variance * variance);
    }
    if (!(A.determinant() > 0.0)) return at;
    Eigen::Vector2d x = A.ldlt().solve(b);
    if (x(0) < 0.0) x << 0.0, b(1) / A(1, 1);
    if (x(1) < 0.0) x << b(0) / A(0, 0), 0.0;
    constexpr double kLeast = 1e-12;
    at = {std::max(x(0), kLeast), std::max(x(1), kLeast)};
  }
  return at;
}

Noise fit_noise(const std::array<const std::vector<Stretch>*, 2>& both,
                const OdometryErrors& errors, Noise noise) {
  std::vector<Square> along;
  std::vector<Square> yaw;
  for (const auto* stretches : both) {
    for (const Stretch& s : *stretches) {
      const Miss miss = miss_of(s, errors);
      yaw.push_back({miss.yaw * miss.yaw, s.way, 0.0});
      along.push_back({miss.along * miss.along, s.walk.x(), s.sway.x()});
      along.push_back({miss.across * miss.across, s.walk.y(), s.sway.y()});
    }
  }
  noise.yaw = fit_components(yaw, noise.yaw);
  for (Square& square : along) square.known *= noise.yaw.per_m;
  noise.along = fit_components(along, noise.along);
  return noise;
}

struct Fit {
  Parameters parameters = Parameters::Zero();
  OdometryErrors errors;
  Noise noise;
};

std::vector<Stretch> without(const std::vector<Stretch>& stretches, const Blocks& blocks,
                             std::size_t left_out) {
  std::vector<Stretch> kept;
  std::copy_if(stretches.begin(), stretches.end(), std::back_inserter(kept),
               [&](const Stretch& s) { return blocks.keeps(s.leg, left_out); });
  return kept;
}

Fit fit_stretches(const std::vector<Stretch>& brief, const std::vector<Stretch>& far,
                  double track) {
  Fit fit;
  for (int round = 0; round < 6; ++round) {
    fit.parameters = improve(far, fit.noise, fit.parameters, track);
    fit.errors = to_errors(fit.parameters, track);
    fit.noise = fit_noise({&brief, &far}, fit.errors, fit.noise);
  }
  return fit;
}

std::vector<double> values_of(const Fit& fit, double track) {
  const OdometryErrors& e = fit.errors;
  const double left = 1.0 + e.scale - 0.5 * track * e.curvature;  // True over measured travel.
  const double right = 1.0 + e.scale + 0.5 * track * e.curvature;
  constexpr double kDeg = 180.0 / std::numbers::pi;
  return {1.0 / left - 1.0,
          1.0 / right - 1.0,
          (1.0 + e.yaw_scale) / (1.0 + e.scale) - 1.0,
          std::sqrt(fit.noise.along.per_m),
          kDeg * std::sqrt(fit.noise.yaw.per_m),
          e.scale,
          e.yaw_scale,
          e.curvature,
          std::sqrt(fit.noise.along.match)};
}

double outlier_share(const std::vector<Stretch>& stretches, const Fit& fit) {
  const auto outliers = std::count_if(stretches.begin(), stretches.end(), [&](const Stretch& s) {
    const Miss miss = miss_of(s, fit.errors);
    constexpr double kSmall = 1e-3;  // [m], [rad] No alignment is more accurate.
    const double along = kOutlier * std::sqrt(fit.noise.along_variance(s));
    const double yaw = kOutlier * std::sqrt(fit.noise.yaw_variance(s));
    return std::abs(miss.along) > std::max(along, kSmall) ||
           std::abs(miss.yaw) > std::max(yaw, kSmall);
  });
  return static_cast<double>(outliers) / static_cast<double>(stretches.size());
}

}  // namespace

std::optional<OdometryFit> fit_odometry(const std::vector<Leg>& legs, double track) {
  constexpr std::size_t kFewest = 2 * Blocks::kCount;
  const std::vector<Stretch> brief = take_stretches(legs, kShort);
  const std::vector<Stretch> far = take_stretches(legs, kLong);
  if (far.size() < kFewest) return std::nullopt;
  const Blocks blocks(legs.size());
  const std::vector<Figure> figures = jackknife([&](std::size_t left_out) {
    return values_of(
        fit_stretches(without(brief, blocks, left_out), without(far, blocks, left_out), track),
        track);
  });
  OdometryFit fit;
  const std::array fields = {&fit.radius_error_left, &fit.radius_error_right, &fit.track_error,
                             &fit.drift_along,       &fit.drift_yaw_deg,      &fit.scale,
                             &fit.yaw_scale,         &fit.curvature,          &fit.match_sigma_m};
  for (std::size_t k = 0; k < fields.size(); ++k) *fields[k] = figures[k];
  for (Figure* figure :
       {&fit.radius_error_left, &fit.radius_error_right, &fit.track_error, &fit.scale}) {
    *figure = widen(*figure, kMapScale);
  }
  // A walk that is small beside the alignment's error cannot be told from none.
  fit.drift_along = widen(fit.drift_along, 0.5 * fit.match_sigma_m.value / std::sqrt(kLong));
  for (Figure* figure : {&fit.drift_along, &fit.drift_yaw_deg}) {
    *figure = widen(*figure, kDriftModel * figure->value);
    figure->interval.low = std::max(figure->interval.low, 0.0);
  }
  const Fit whole = fit_stretches(brief, far, track);
  fit.errors = whole.errors;
  fit.stretches = far.size();
  for (const Stretch& s : far) fit.way_m += s.way;
  fit.outliers = outlier_share(far, whole);
  return fit;
}

}  // namespace castaway::testbed
