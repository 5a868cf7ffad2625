#include "tools/twin/odometry/odometry_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/twin/odometry/drive_fit.hpp"

namespace castaway::testbed {
namespace {

constexpr double kClear = 0.03;  // [m] Alignments are more accurate.

double along_of(const Leg& leg) {
  double along = 0.0;
  for (const OdometryStep& step : leg.steps) along += step.along;
  return along;
}

/// True if the robot drives so far, and so straight, that the sign of its motion is clear.
bool is_clear(const Leg& leg) {
  constexpr double kBend = 0.5;  // [rad]
  return !leg.breaks && std::abs(leg.T_start_end.yaw) < kBend &&
         std::abs(leg.T_start_end.x) > kClear && std::abs(along_of(leg)) > kClear;
}

bool disagrees(const Leg& leg) { return is_clear(leg) && leg.T_start_end.x * along_of(leg) < 0.0; }

constexpr double kShort = 1.0;  // [m] Lengths of stretches.
constexpr double kLong = 4.0;
constexpr double kDriftModel = 0.06;   // Standard deviation of a drift by the model; relative.
constexpr double kMountModel = 0.005;  // [m] The same of the mount of the lidar.
constexpr double kMountModelDeg = 0.1;
constexpr std::size_t kFewestStretches = 2 * Blocks::kCount;
constexpr double kDeg = 180.0 / std::numbers::pi;

/// `is_unsigned`: odometry does not tell reversing.
Stretches take_both(const std::vector<Leg>& legs, bool is_unsigned) {
  if (is_unsigned) return take_both(sign_distances(legs), false);
  return {take_stretches(legs, kShort), take_stretches(legs, kLong)};
}

std::vector<Stretch> without(const std::vector<Stretch>& stretches, const Blocks& blocks,
                             std::size_t left_out) {
  std::vector<Stretch> kept;
  std::copy_if(stretches.begin(), stretches.end(), std::back_inserter(kept),
               [&](const Stretch& s) { return blocks.keeps(s.leg, left_out); });
  return kept;
}

/// In the order of `fields_of`.
std::vector<double> values_of(const DriveFit& fit, double track) {
  const OdometryErrors& e = fit.errors.odometry;
  const SE2& T_base_drive = fit.errors.T_base_drive;
  const double left = 1.0 + e.scale - 0.5 * track * e.curvature;  // True over measured travel.
  const double right = 1.0 + e.scale + 0.5 * track * e.curvature;
  return {1.0 / left - 1.0,
          1.0 / right - 1.0,
          (1.0 + e.yaw_scale) / (1.0 + e.scale) - 1.0,
          std::sqrt(fit.noise.along_per_m),
          kDeg * std::sqrt(fit.noise.yaw_per_m),
          kDeg * std::sqrt(fit.noise.yaw_per_rad),
          e.scale,
          e.yaw_scale,
          e.curvature,
          T_base_drive.x,
          T_base_drive.y,
          kDeg * T_base_drive.yaw,
          std::sqrt(fit.noise.match),
          std::sqrt(fit.noise.stamp)};
}

std::array<Figure*, 14> fields_of(OdometryFit& fit) {
  return {&fit.radius_error_left, &fit.radius_error_right, &fit.track_error, &fit.drift_along,
          &fit.drift_yaw_deg,     &fit.drift_turn_deg,     &fit.scale,       &fit.yaw_scale,
          &fit.curvature,         &fit.drive_x_m,          &fit.drive_y_m,   &fit.drive_yaw_deg,
          &fit.match_sigma_m,     &fit.stamp_sigma_s};
}

double outlier_share(const std::vector<Stretch>& stretches, const DriveFit& fit) {
  constexpr double kOutlier = 4.0;  // Standard deviations.
  constexpr double kSmall = 1e-3;   // [m], [rad] No alignment is more accurate.
  const auto outliers = std::count_if(stretches.begin(), stretches.end(), [&](const Stretch& s) {
    const SE2 miss = miss_of(s, fit.errors);
    const Eigen::Vector3d limits = kOutlier * fit.noise.variances(s).cwiseSqrt();
    return std::abs(miss.x) > std::max(limits(0), kSmall) ||
           std::abs(miss.yaw) > std::max(limits(2), kSmall);
  });
  return static_cast<double>(outliers) / static_cast<double>(stretches.size());
}

/// The figures with intervals.
OdometryFit figures_of(const Stretches& all, const Blocks& blocks, double track, YawWalk walk) {
  const std::vector<Figure> figures = jackknife([&](std::size_t left_out) {
    const Stretches kept{without(all.brief, blocks, left_out), without(all.far, blocks, left_out)};
    return values_of(fit_drive(kept, track, walk), track);
  });
  OdometryFit fit;
  const auto fields = fields_of(fit);
  for (std::size_t k = 0; k < fields.size(); ++k) *fields[k] = figures[k];
  return fit;
}

/// Sets what has no interval. `whole`: the fit to all stretches.
void describe(const Stretches& all, const DriveFit& whole, OdometryFit& fit) {
  fit.errors = whole.errors;
  fit.noise = whole.noise;
  fit.stretches = all.far.size();
  for (const Stretch& s : all.far) fit.way_m += s.way;
  fit.yaw_by_turn = yaw_by_turn(all.brief, whole.errors, whole.noise);
  fit.along_by_speed = along_by_speed(all.brief, whole.errors, whole.noise);
  fit.outliers = outlier_share(all.far, whole);
}

/// Widens intervals by what no part of the log shows.
void widen_by_model(OdometryFit& fit) {
  for (Figure* figure :
       {&fit.radius_error_left, &fit.radius_error_right, &fit.track_error, &fit.scale}) {
    *figure = widen(*figure, kMapScale);
  }
  for (Figure* figure : {&fit.drive_x_m, &fit.drive_y_m}) *figure = widen(*figure, kMountModel);
  fit.drive_yaw_deg = widen(fit.drive_yaw_deg, kMountModelDeg);
  // A walk that is small beside the alignment's error cannot be told from none.
  fit.drift_along = widen(fit.drift_along, 0.5 * fit.match_sigma_m.value / std::sqrt(kLong));
  for (Figure* figure : {&fit.drift_along, &fit.drift_yaw_deg, &fit.drift_turn_deg}) {
    *figure = widen(*figure, kDriftModel * figure->value);
  }
  for (Figure* figure : {&fit.drift_along, &fit.drift_yaw_deg, &fit.drift_turn_deg,
                         &fit.match_sigma_m, &fit.stamp_sigma_s}) {
    figure->interval.low = std::max(figure->interval.low, 0.0);
  }
}

}  // namespace

bool is_distance_unsigned(const std::vector<Leg>& legs) {
  constexpr int kFewest = 10;
  int reversing = 0;
  int ahead = 0;
  for (const Leg& leg : legs) {
    if (!is_clear(leg) || leg.T_start_end.x > 0.0) continue;
    ++reversing;
    if (along_of(leg) > 0.0) ++ahead;
  }
  return ahead >= kFewest && 2 * ahead > reversing;
}

std::vector<Leg> sign_distances(std::vector<Leg> legs) {
  for (Leg& leg : legs) {
    if (!disagrees(leg)) continue;
    for (OdometryStep& step : leg.steps) {
      step.along = -step.along;
      step.across = -step.across;
    }
  }
  return legs;
}

std::optional<OdometryFit> fit_odometry(const std::vector<Leg>& legs, double track) {
  const bool is_unsigned = is_distance_unsigned(legs);
  const Stretches all = take_both(legs, is_unsigned);
  if (all.far.size() < kFewestStretches) return std::nullopt;
  const Blocks blocks(legs.size());
  const DriveFit both = fit_drive(all, track);
  const YawWalk walk = choose_walk({&all.brief, &all.far}, both.errors, both.noise);
  OdometryFit fit = figures_of(all, blocks, track, walk);
  if (walk != YawWalk::kTravelAndTurn) {
    const OdometryFit with_both = figures_of(all, blocks, track, YawWalk::kTravelAndTurn);
    Figure& missing = walk == YawWalk::kTurn ? fit.drift_yaw_deg : fit.drift_turn_deg;
    missing.interval.high =
        (walk == YawWalk::kTurn ? with_both.drift_yaw_deg : with_both.drift_turn_deg).interval.high;
  }
  widen_by_model(fit);
  fit.unsigned_distance = is_unsigned;
  describe(all, fit_drive(all, track, walk), fit);
  fit.slip = fit_slips(all.brief, fit.errors, fit.noise, track, blocks);
  return fit;
}

DriveErrors fit_drive_errors(const std::vector<Leg>& legs, double track) {
  const Stretches all = take_both(legs, is_distance_unsigned(legs));
  return all.far.size() < kFewestStretches ? DriveErrors{} : fit_drive(all, track).errors;
}

}  // namespace castaway::testbed
