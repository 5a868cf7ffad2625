#include "tools/twin/fits/clock_fit.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kLongestPeriod = 0.125;  // [s] of odometry
constexpr double kLongestPause = 0.6;     // [s] between scans
constexpr double kFewestChanges = 2.0;    // [rad/s]

/// A leg's turn as a function of the offset, to first order.
struct TurnSample {
  double miss = 0.0;    ///< [rad] By odometry minus by the map, without offset.
  double change = 0.0;  ///< [rad/s] Change of the turn rate.
  double around = 0.0;  ///< [rad/s] The same from readings that do not enter `miss` and `change`.
  std::size_t scan = 0;
};

/// Mean turn rate of odometry over a time. [rad/s]
std::optional<double> turn_rate(const AlignedLog& log, Stamp from, Stamp to) {
  const auto before = log.T_odom_base.at(from);
  const auto after = log.T_odom_base.at(to);
  if (!before || !after) return std::nullopt;
  return localization::wrap_angle(after->yaw - before->yaw) / seconds(to - from);
}

/// Change of the turn rate between the times `a` to `b` and `c` to `d`.
std::optional<double> turn_change(const AlignedLog& log, Stamp a, Stamp b, Stamp c, Stamp d) {
  const auto first = turn_rate(log, a, b);
  const auto second = turn_rate(log, c, d);
  if (!first || !second) return std::nullopt;
  return *second - *first;
}

Stamp sweep_of(const LaserScan& scan) {
  return scan.time_increment * static_cast<std::int64_t>(scan.ranges.size());
}

std::vector<TurnSample> take_samples(const AlignedLog& log, const OdometryErrors& errors) {
  constexpr Stamp kHalf = std::chrono::milliseconds(25);  // Of the time of a turn rate.
  constexpr Stamp kAside = std::chrono::milliseconds(125);
  constexpr double kAnyTrack = 0.3;
  std::vector<TurnSample> samples;
  const std::vector<Leg> legs = take_legs(log, kAnyTrack);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Stamp begin = log.scans[i].scan.stamp;
    const Stamp end = log.scans[i + 1].scan.stamp;
    if (legs[i].breaks || seconds(end - begin) > kLongestPause) continue;
    const Stamp swept = end + sweep_of(log.scans[i + 1].scan);
    const auto change = turn_change(log, begin - kHalf, begin + kHalf, end - kHalf, end + kHalf);
    const auto around = turn_change(log, begin - kAside, begin - kHalf,
                                    std::max(swept, end + kHalf), swept + kAside);
    if (!change || !around) continue;
    const double by_odometry = correct_motion(legs[i].steps, errors).yaw;
    samples.push_back(
        {localization::wrap_angle(by_odometry - legs[i].T_start_end.yaw), *change, *around, i});
  }
  return samples;
}

/// The offset that explains the misses best, without outliers. The changes share their noise with
/// the misses, so that least squares would be biased: those around serve as instrument (P. G.
/// Wright, "The Tariff on Animal and Vegetable Oils", 1928, appendix B).
double fit_offset(const std::vector<TurnSample>& samples, const Blocks& blocks,
                  std::size_t left_out) {
  constexpr double kOutlier = 3.0;
  double offset = 0.0;
  double limit = 0.2;  // [rad]
  for (int round = 0; round < 8; ++round) {
    double product = 0.0;
    double square = 0.0;
    double misses = 0.0;
    double count = 0.0;
    for (const TurnSample& s : samples) {
      const double miss = s.miss - offset * s.change;
      if (!blocks.keeps(s.scan, left_out) || std::abs(miss) > limit) continue;
      product += s.miss * s.around;
      square += s.change * s.around;
      misses += miss * miss;
      count += 1.0;
    }
    if (square <= 0.0) break;
    offset = product / square;
    limit = std::max(kOutlier * std::sqrt(misses / count), 1e-4);
  }
  return offset;
}

}  // namespace

std::optional<ClockFit> fit_clock(const AlignedLog& log, const OdometryErrors& errors) {
  if (!(log.odometry_period_s > 0.0) || log.odometry_period_s > kLongestPeriod) return std::nullopt;
  const std::vector<TurnSample> samples = take_samples(log, errors);
  ClockFit fit;
  for (const TurnSample& s : samples) {
    fit.turn_changes += s.change * s.around;
    fit.samples.push_back({s.change, s.miss});
  }
  fit.turn_changes = std::sqrt(std::max(fit.turn_changes, 0.0));
  if (fit.turn_changes < kFewestChanges) return std::nullopt;
  const Blocks blocks(log.scans.size());
  fit.offset_s = jackknife([&](std::size_t left_out) {
                   return std::vector{fit_offset(samples, blocks, left_out)};
                 }).front();
  return fit;
}

}  // namespace castaway::testbed
