#include "localization/input/layered_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace castaway::localization {
namespace {

constexpr double kMostRise = 0.6;          // Of a flat surface.
constexpr std::size_t kMostColumns = 360;  // Directions that are looked at.
constexpr double kGoldenRatio = 0.6180339887498949;

/// A beam of a layer.
struct LayerBeam {
  std::size_t layer = 0;
  std::size_t column = 0;
};

/// An angle by its cosine and sine.
struct Direction {
  explicit Direction(double angle) : cos(std::cos(angle)), sin(std::sin(angle)) {}
  double cos, sin;
};

/// Directions of the layers' beams.
class LayerFan {
 public:
  LayerFan(const LaserScan& scan, const BeamSelection& selection)
      : scan_(scan), selection_(selection), by_elevation_(scan.layers.size()) {
    for (const ScanLayer& layer : scan.layers) elevations_.emplace_back(layer.elevation);
    const auto elevation = [&](std::size_t layer) { return scan.layers[layer].elevation; };
    std::iota(by_elevation_.begin(), by_elevation_.end(), std::size_t{0});
    std::sort(by_elevation_.begin(), by_elevation_.end(),
              [&](std::size_t a, std::size_t b) { return elevation(a) < elevation(b); });
    level_ = *std::min_element(by_elevation_.begin(), by_elevation_.end(),
                               [&](std::size_t a, std::size_t b) {
                                 return std::abs(elevation(a)) < std::abs(elevation(b));
                               });
  }

  /// Layers, the lowest first.
  [[nodiscard]] const std::vector<std::size_t>& by_elevation() const { return by_elevation_; }
  [[nodiscard]] std::size_t level() const { return level_; }
  /// Of a column's beams, in the plane.
  [[nodiscard]] Direction direction(std::size_t column) const {
    return Direction(scan_.beam_angle(column));
  }
  /// The end point in the lidar's frame; nothing without a valid return. `direction` is that of the
  /// beam's column.
  [[nodiscard]] std::optional<Eigen::Vector3d> end(const LayerBeam& beam,
                                                   const Direction& direction) const {
    const double range = scan_.layers[beam.layer].ranges[beam.column];
    if (!is_valid_range(scan_, selection_, range)) return std::nullopt;
    const Direction& elevation = elevations_[beam.layer];
    const double flat = range * elevation.cos;
    return Eigen::Vector3d(flat * direction.cos, flat * direction.sin, range * elevation.sin);
  }

 private:
  const LaserScan& scan_;
  const BeamSelection& selection_;
  std::vector<std::size_t> by_elevation_;
  std::vector<Direction> elevations_;
  std::size_t level_ = 0;
};

/// Beams by kind, in the order of their directions.
struct SortedBeams {
  std::vector<LayerBeam> level;
  std::vector<LayerBeam> tilted;
  std::vector<LayerBeam> flat;
};

using Column = std::vector<std::optional<Eigen::Vector3d>>;

/// True if the return joins another one along a flat line, and none along a steep one.
bool is_flat(const Column& column, std::size_t k) {
  bool flat = false;
  for (const std::size_t neighbour : {k - 1, k + 1}) {
    if (neighbour >= column.size() || !column[neighbour]) continue;
    const Eigen::Vector3d d = *column[neighbour] - *column[k];
    if (std::abs(d.z()) > kMostRise * d.head<2>().norm()) return false;
    flat = true;
  }
  return flat;
}

/// Returns in one direction, the lowest layer first, in axes parallel to those of base.
Column column_of(const LayerFan& fan, const Eigen::Matrix3d& R_base_laser, std::size_t column) {
  Column ends;
  ends.reserve(fan.by_elevation().size());
  const Direction direction = fan.direction(column);
  for (const std::size_t layer : fan.by_elevation()) {
    auto end = fan.end({layer, column}, direction);
    if (end) *end = R_base_laser * *end;
    ends.push_back(end);
  }
  return ends;
}

SortedBeams sort_beams(const LayerFan& fan, const Eigen::Matrix3d& R_base_laser,
                       std::size_t columns) {
  SortedBeams sorted;
  for (const std::size_t column : even_indices(columns, kMostColumns)) {
    const Column ends = column_of(fan, R_base_laser, column);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (!ends[k]) continue;
      const std::size_t layer = fan.by_elevation()[k];
      std::vector<LayerBeam>& tall = layer == fan.level() ? sorted.level : sorted.tilted;
      (is_flat(ends, k) ? sorted.flat : tall).push_back({layer, column});
    }
  }
  return sorted;
}

/// At most `count` of the beams, one from each of as many equal parts: layers vary.
std::vector<LayerBeam> spread(const std::vector<LayerBeam>& beams, int count) {
  const auto parts = static_cast<std::size_t>(count);
  if (beams.size() <= parts) return beams;
  std::vector<LayerBeam> some;
  const double part = static_cast<double>(beams.size()) / static_cast<double>(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    const double at =
        static_cast<double>(i) + std::fmod(static_cast<double>(i) * kGoldenRatio, 1.0);
    some.push_back(beams[std::min(static_cast<std::size_t>(at * part), beams.size() - 1)]);
  }
  return some;
}

/// Projects beams at their times.
class Projection {
 public:
  Projection(const LaserScan& scan, const TransformBuffer& T_odom_base, const SE2& T_reference_odom)
      : scan_(scan), T_odom_base_(T_odom_base), T_reference_odom_(T_reference_odom) {}

  /// Returns false if the motion at a beam's time is unknown.
  bool append(const LayerFan& fan, const std::vector<LayerBeam>& beams, BeamKind kind,
              ScanPoints& points) const {
    for (const LayerBeam& beam : beams) {
      const auto T_odom_beam = T_odom_base_.at(scan_.beam_stamp(beam.column));
      if (!T_odom_beam) return false;
      append_beam(points, to_se3(T_reference_odom_ * *T_odom_beam) * scan_.T_base_laser,
                  *fan.end(beam, fan.direction(beam.column)));
      points.kinds.push_back(kind);
    }
    return true;
  }

 private:
  const LaserScan& scan_;
  const TransformBuffer& T_odom_base_;
  SE2 T_reference_odom_;
};

/// Share of the beams of the level layer with a valid range.
double valid_share(const LaserScan& scan, const BeamSelection& selection, std::size_t level) {
  const std::vector<float>& ranges = scan.layers[level].ranges;
  const auto valid = std::count_if(ranges.begin(), ranges.end(), [&](float range) {
    return is_valid_range(scan, selection, range);
  });
  return static_cast<double>(valid) / static_cast<double>(ranges.size());
}

}  // namespace

std::optional<ScanPoints> project_layers(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                         Stamp reference, const BeamSelection& selection) {
  const std::optional<SE2> T_odom_reference = T_odom_base.at(reference);
  if (!T_odom_reference || !T_odom_base.at(scan.stamp)) return std::nullopt;
  const LayerFan fan(scan, selection);
  const SortedBeams sorted = sort_beams(fan, scan.T_base_laser.linear(), scan.ranges.size());
  const Projection projection(scan, T_odom_base, T_odom_reference->inverse());
  ScanPoints points;
  if (!scan.ranges.empty()) points.valid_share = valid_share(scan, selection, fan.level());
  const bool known =
      projection.append(fan, spread(sorted.level, selection.max_beams), BeamKind::kLevel, points) &&
      projection.append(fan, spread(sorted.tilted, selection.max_tilted), BeamKind::kTilted,
                        points) &&
      projection.append(fan, spread(sorted.flat, selection.max_flat), BeamKind::kFlat, points);
  return known ? std::optional(points) : std::nullopt;
}

}  // namespace castaway::localization
