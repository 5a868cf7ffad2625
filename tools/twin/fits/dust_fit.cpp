#include "tools/twin/fits/dust_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kDustScans = 1000;
constexpr double kOnDustWall = 0.25;     // [m] Ranges this close to the map's are the wall's.
constexpr double kBeforeDustWall = 0.4;  // [m] A grain is this far before the wall.
constexpr double kSeenAgain = 0.6;       // [m] Between end points on one thing, 1 scan apart.

/// A scan, and what the map says of it.
struct DustView {
  const AlignedScan& aligned;
  std::vector<ExpectedBeam> expected;  ///< Empty if the motion is unknown.
};

DustView view_dust(const AlignedLog& log, std::size_t index) {
  const AlignedScan& aligned = log.scans[index];
  return {aligned,
          expect_scan(log, aligned, std::min(aligned.scan.range_max, kDustSteps * kDustStep))};
}

/// A beam in map.
struct DustRay {
  Eigen::Vector2d from;
  Eigen::Vector2d direction;
};

DustRay dust_ray(const AlignedLog& log, const AlignedScan& aligned, std::size_t i) {
  const LaserScan& scan = aligned.scan;
  const SE2 T_path_first = log.T_path_base.at(scan.stamp).value();
  const SE2 T_path_base = log.T_path_base.at(scan.beam_stamp(i)).value();
  const SE2 T_map_base = aligned.T_map_base * (T_path_first.inverse() * T_path_base);
  const Eigen::Isometry3d T_map_laser = localization::to_se3(T_map_base) * scan.T_base_laser;
  const double angle = scan.beam_angle(i);
  const Eigen::Vector3d d =
      T_map_laser.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
  return {T_map_laser.translation().head<2>(), d.head<2>().normalized()};
}

/// Adds the end points, in map, of all that stands before the walls.
void add_foreign_points(const AlignedLog& log, const DustView& view,
                        std::vector<Eigen::Vector2d>& points) {
  const LaserScan& scan = view.aligned.scan;
  for (std::size_t i = 0; i < view.expected.size(); ++i) {
    const double r = scan.ranges[i];
    if (!(r >= scan.range_min && r < view.expected[i].range - kOnDustWall)) continue;
    const DustRay ray = dust_ray(log, view.aligned, i);
    points.emplace_back(ray.from + r * ray.direction);
  }
}

/// True if the map has a straight wall at beam `i`, and both neighbours on each side return it.
bool is_dust_beam(const DustView& view, std::size_t i) {
  const LaserScan& scan = view.aligned.scan;
  const ExpectedBeam& beam = view.expected[i];
  if (!beam.straight || !(scan.ranges[i] >= scan.range_min)) return false;
  if (beam.range - kBeforeDustWall <= scan.range_min) return false;
  for (const std::size_t k : {i - 2, i - 1, i + 1, i + 2}) {
    const ExpectedBeam& next = view.expected[k];
    if (!next.wall || !(std::abs(scan.ranges[k] - next.range) < kOnDustWall)) return false;
  }
  return true;
}

/// 1 at the steps of a beam that are not near any of the points, 0 at the others.
DustSteps clear_steps(const DustRay& ray, const std::vector<Eigen::Vector2d>& points) {
  DustSteps clear;
  clear.fill(1.0);
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d to = p - ray.from;
    const double along = to.dot(ray.direction);
    const double half_squared = kSeenAgain * kSeenAgain - to.squaredNorm() + along * along;
    if (half_squared <= 0.0) continue;
    const double half = std::sqrt(half_squared);
    if (along + half < 0.0) continue;
    std::fill(clear.begin() + static_cast<std::ptrdiff_t>(dust_step(along - half)),
              clear.begin() + static_cast<std::ptrdiff_t>(dust_step(along + half)) + 1, 0.0);
  }
  return clear;
}

/// Adds a beam. Where a grain would be taken for a thing that is seen again, beams are not at risk
/// either: this leaves the rate unbiased if there are many grains.
void add_dust_beam(const DustView& view, std::size_t i, const DustSteps& clear,
                   DustCounts& counts) {
  const LaserScan& scan = view.aligned.scan;
  const double r = scan.ranges[i];
  const double limit = view.expected[i].range - kBeforeDustWall;
  const double to = std::min(r, limit);
  for (std::size_t k = dust_step(scan.range_min); k <= dust_step(to); ++k) {
    const double low = std::max(kDustStep * static_cast<double>(k), scan.range_min);
    const double high = std::min(kDustStep * static_cast<double>(k + 1), to);
    counts.metres[k] += clear[k] * std::max(high - low, 0.0);
  }
  counts.beams += 1.0;
  if (r < limit && clear[dust_step(r)] > 0.0) counts.hits.push_back(r);
}

/// Adds a scan, unless the motion within it or one of the scans around is unknown.
void count_dust(const AlignedLog& log, std::size_t index, DustCounts& counts) {
  const std::array<DustView, 3> views{view_dust(log, index - 1), view_dust(log, index),
                                      view_dust(log, index + 1)};
  const DustView& view = views[1];
  if (std::any_of(views.begin(), views.end(), [](const auto& v) { return v.expected.empty(); })) {
    return;
  }
  std::vector<Eigen::Vector2d> points;
  add_foreign_points(log, views[0], points);
  add_foreign_points(log, views[2], points);
  for (std::size_t i = 2; i + 2 < view.expected.size(); ++i) {
    if (!is_dust_beam(view, i)) continue;
    add_dust_beam(view, i, clear_steps(dust_ray(log, view.aligned, i), points), counts);
  }
}

}  // namespace

std::optional<DustFit> fit_dust(const AlignedLog& log) {
  constexpr double kFewestDustBeams = 500.0;
  constexpr double kNoneAt = 3.0;  // The mean that shows no grain at all in 5 % of logs.
  std::vector<DustCounts> blocks(Blocks::kCount);
  for (const std::size_t i : spread_scans(log, kDustScans)) {
    if (i == 0 || i + 1 == log.scans.size()) continue;
    count_dust(log, i, blocks[i * Blocks::kCount / log.scans.size()]);
  }
  const DustCounts all = sum_dust(blocks, Blocks::kCount);
  DustFit fit;
  fit.range_m = dust_range(all);
  const DustSplit split = split_dust(all, fit.range_m);
  fit.hits = static_cast<std::size_t>(split.near_hits);
  fit.beams = static_cast<std::size_t>(all.beams);
  fit.metres = split.near_metres;
  fit.other_per_m = split.far_rate();
  fit.bins = bin_dust(all);
  if (all.beams < kFewestDustBeams || fit.metres <= 0.0) return std::nullopt;
  fit.per_m = jackknife([&](std::size_t left_out) {
                const DustCounts counts = sum_dust(blocks, left_out);
                return std::vector{split_dust(counts, fit.range_m).grains()};
              }).front();
  constexpr double kModel = 0.03;  // Relative; small things that stand or move count, too.
  fit.per_m = widen(fit.per_m, kModel * fit.per_m.value);
  fit.per_m.interval.low = std::max(fit.per_m.interval.low, 0.0);
  fit.per_m.interval.high += kNoneAt / fit.metres;
  return fit;
}

}  // namespace castaway::testbed
