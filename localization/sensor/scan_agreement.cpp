#include "localization/sensor/scan_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace castaway::localization {
namespace {

/// Direction and length of a beam.
struct Beam {
  double angle = 0.0;
  double range = 0.0;
};

Eigen::Vector2d mean_origin(const ScanPoints& points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += Eigen::Vector2d(points.origin_x[i], points.origin_y[i]);
  }
  return sum / static_cast<double>(points.size());
}

Beam beam_to(const Eigen::Vector2d& origin, const Eigen::Vector2d& end) {
  const Eigen::Vector2d d = end - origin;
  return {std::atan2(d.y(), d.x()), d.norm()};
}

std::vector<Beam> beams_by_angle(const ScanPoints& points, const Eigen::Vector2d& origin) {
  std::vector<Beam> beams;
  beams.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.kind(i) != BeamKind::kLevel) continue;
    beams.push_back(beam_to(origin, {points.x[i], points.y[i]}));
  }
  std::sort(beams.begin(), beams.end(),
            [](const Beam& a, const Beam& b) { return a.angle < b.angle; });
  return beams;
}

enum class Comparison { kAgrees, kLookedThrough, kUnknown };

Comparison compare(const ScanAgreementConfig& config, const std::vector<Beam>& before,
                   const Beam& beam) {
  if (before.empty()) return Comparison::kUnknown;
  const auto after = std::lower_bound(before.begin(), before.end(), beam.angle,
                                      [](const Beam& b, double angle) { return b.angle < angle; });
  const bool at_seam = after == before.begin() || after == before.end();
  const Beam& right = at_seam ? before.back() : *std::prev(after);
  const Beam& left = at_seam ? before.front() : *after;
  const double turn = at_seam ? 2.0 * std::numbers::pi : 0.0;
  if (left.angle + turn - right.angle > config.widest_gap) return Comparison::kUnknown;
  const double slack = config.tolerance + config.tolerance_share * beam.range;
  if (beam.range > std::max(left.range, right.range) + slack) return Comparison::kUnknown;
  const bool nearer = beam.range < std::min(left.range, right.range) - slack;
  return nearer ? Comparison::kLookedThrough : Comparison::kAgrees;
}

/// Number of comparable points, and how many of them agree.
struct Tally {
  int known = 0;
  int agree = 0;
};

/// Compares the points of `other` with what `seer` saw, and counts them.
void count(const ScanAgreementConfig& config, const ScanPoints& seer, const ScanPoints& other,
           const SE2& T_seer_other, Tally& tally) {
  const Eigen::Vector2d origin = mean_origin(seer);
  const std::vector<Beam> beams = beams_by_angle(seer, origin);
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (other.kind(i) != BeamKind::kLevel) continue;
    const Eigen::Vector2d end = T_seer_other * Eigen::Vector2d(other.x[i], other.y[i]);
    const Comparison result = compare(config, beams, beam_to(origin, end));
    if (result == Comparison::kUnknown) continue;
    ++tally.known;
    if (result == Comparison::kAgrees) ++tally.agree;
  }
}

}  // namespace

std::optional<double> scan_agreement(const ScanAgreementConfig& config, const ScanPoints& before,
                                     const ScanPoints& now, const SE2& T_before_now) {
  if (before.empty() || now.empty()) return std::nullopt;
  Tally tally;
  count(config, before, now, T_before_now, tally);
  count(config, now, before, T_before_now.inverse(), tally);
  if (tally.known < config.least) return std::nullopt;
  return static_cast<double>(tally.agree) / tally.known;
}

}  // namespace castaway::localization
