#include "tools/batch/evaluate/stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "sim/common/random.hpp"

namespace castaway::testbed {
namespace {

void shorten_to(double range, float& r) {
  if (!(static_cast<double>(r) < range)) r = static_cast<float>(range);
}

/// Ends the beams of all layers at azimuth `i` at a person `r` [m] away, unless they pass above.
void meet_in_layers(LaserScan& scan, std::size_t i, double r) {
  constexpr double kTall = 1.75;  // [m]
  const double lidar_height = scan.T_base_laser.translation().z();
  for (localization::ScanLayer& layer : scan.layers) {
    const double z = lidar_height + r * std::tan(layer.elevation);
    if (z < 0.0 || z > kTall) continue;
    shorten_to(r / std::cos(layer.elevation), layer.ranges[i]);
  }
}

/// Puts one person into the scan and marks the beams that meet it in `met`.
void add_person(LaserScan& scan, std::vector<bool>& met, localization::Rng& rng) {
  constexpr double kRadius = 0.25;  // [m]
  const double d = sim::draw_between(0.6, 2.5, rng);
  const auto count = static_cast<double>(scan.ranges.size());
  const double angle =
      scan.beam_angle(0) + sim::draw_between(0.0, count, rng) * scan.angle_increment;
  const double half = std::asin(kRadius / d);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double off = localization::wrap_angle(scan.beam_angle(i) - angle);
    if (std::abs(off) >= half) continue;
    met[i] = true;
    const double r =
        d * std::cos(off) - std::sqrt(kRadius * kRadius - std::pow(d * std::sin(off), 2));
    shorten_to(r, scan.ranges[i]);
    meet_in_layers(scan, i, r);
  }
}

void block(LaserScan& scan, double share, localization::Rng& rng) {
  std::vector<bool> met(scan.ranges.size(), false);
  const auto wanted =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(met.size())));
  while (std::count(met.begin(), met.end(), true) < wanted) add_person(scan, met, rng);
}

void drop_beyond(double range_max, std::vector<float>& ranges) {
  for (float& r : ranges) {
    if (std::isfinite(r) && static_cast<double>(r) > range_max) {
      r = std::numeric_limits<float>::infinity();
    }
  }
}

void shorten(LaserScan& scan, double range_max) {
  drop_beyond(range_max, scan.ranges);
  for (localization::ScanLayer& layer : scan.layers) drop_beyond(range_max, layer.ranges);
}

using Tile = std::pair<int, int>;

void erase_walls(RosMap& map, double share, localization::Rng& rng) {
  const int cells = std::max(1, static_cast<int>(std::lround(1.0 / map.resolution)));
  std::set<Tile> walls;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) >= 65) walls.insert({column / cells, row / cells});
    }
  }
  std::set<Tile> erased;
  for (const Tile& tile : walls) {
    if (sim::draw_between(0.0, 1.0, rng) < share) erased.insert(tile);
  }
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      std::int8_t& cell = map.cells[static_cast<std::size_t>(row * map.width + column)];
      if (cell >= 65 && erased.contains({column / cells, row / cells})) cell = 0;
    }
  }
}

/// Adds boxes until the density is reached or no more free places are found.
void add_boxes(RosMap& map, double per_m2, localization::Rng& rng) {
  const auto free = std::count(map.cells.begin(), map.cells.end(), std::int8_t{0});
  const double area = static_cast<double>(free) * map.resolution * map.resolution;
  const int edge = std::max(1, static_cast<int>(std::lround(0.5 / map.resolution)));
  auto left = std::lround(per_m2 * area);
  for (long tries = 1000 * left; left > 0 && tries > 0; --tries) {
    const int column = static_cast<int>(sim::draw_between(0.0, std::max(1, map.width - edge), rng));
    const int row = static_cast<int>(sim::draw_between(0.0, std::max(1, map.height - edge), rng));
    if (map.at(column, row) != 0) continue;
    --left;
    for (int r = row; r < std::min(row + edge, map.height); ++r) {
      for (int c = column; c < std::min(column + edge, map.width); ++c) {
        map.cells[static_cast<std::size_t>(r * map.width + c)] = 100;
      }
    }
  }
}

}  // namespace

void validate(const StressConfig& config) {
  if (!(config.blocked_share >= 0.0 && config.blocked_share <= 0.9)) {
    throw std::invalid_argument("the blocked share must be from 0 to 0.9");
  }
  if (!(config.range_max >= 0.0)) throw std::invalid_argument("range_max must not be negative");
  if (!(config.erased_share >= 0.0 && config.erased_share <= 1.0)) {
    throw std::invalid_argument("the erased share must be from 0 to 1");
  }
  if (!(config.boxes_per_m2 >= 0.0 && config.boxes_per_m2 <= 1.0)) {
    throw std::invalid_argument("boxes per square metre must be from 0 to 1");
  }
}

Frames apply_stress(const Frames& frames, const StressConfig& config, localization::Rng& rng) {
  validate(config);
  Frames result;
  std::size_t scans = 0;
  for (const Frame& frame : frames) {
    result.push_back(frame);
    auto* scan = std::get_if<ScanFrame>(&result.back().data);
    if (scan == nullptr) continue;
    if (config.odd_scans_only && scans++ % 2 == 0) {
      result.pop_back();
      continue;
    }
    if (config.blocked_share > 0.0) block(scan->scan, config.blocked_share, rng);
    if (config.range_max > 0.0) shorten(scan->scan, config.range_max);
  }
  return result;
}

RosMap damage_map(const RosMap& map, const StressConfig& config, localization::Rng& rng) {
  validate(config);
  RosMap result = map;
  if (config.erased_share > 0.0) erase_walls(result, config.erased_share, rng);
  if (config.boxes_per_m2 > 0.0) add_boxes(result, config.boxes_per_m2, rng);
  return result;
}

}  // namespace castaway::testbed
