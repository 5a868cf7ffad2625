#include "localization/space/stack/stack_frame.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr std::int64_t kMostStackCells = 1 << 28;
constexpr int kRowsOfTiles = 32;  // Planes begin with a tile of each level, and with a bin.

int up_to_multiple(int value, int of) { return (value + of - 1) / of * of; }

int count_of(double length, double unit) { return static_cast<int>(std::ceil(length / unit)); }

/// Lowest and highest drivable ground. [m]
std::pair<double, double> heights_of(const ElevationMap& ground) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const GroundSurface& surface : ground.surfaces) {
    if (!surface.drivable) continue;
    lowest = std::min(lowest, static_cast<double>(surface.z));
    highest = std::max(highest, static_cast<double>(surface.z));
  }
  return {lowest, highest};
}

}  // namespace

void validate(const StackConfig& config) {
  if (!(config.resolution > 0.0 && config.height > 0.0)) {
    throw std::invalid_argument("cells of a 3-D search must be larger than 0");
  }
  if (!(config.reach > 0.0 && config.reach <= 200.0 && config.reach_up >= 0.0 &&
        config.reach_up <= 50.0)) {
    throw std::invalid_argument("a 3-D search reaches up to 200 m around and 50 m up and down");
  }
}

StackFrame::StackFrame(const ElevationMap& ground, const StackConfig& config)
    : height(config.height) {
  validate(config);
  const GridFrame& fine = ground.frame;
  factor = std::max(1, static_cast<int>(std::lround(config.resolution / fine.resolution)));
  plane = {up_to_multiple(fine.width, factor) / factor,
           up_to_multiple(fine.height, factor) / factor, fine.resolution * factor, fine.T_map_grid};
  reach = count_of(config.reach, plane.resolution);
  reach_up = count_of(config.reach_up, height);
  pitch = up_to_multiple(plane.height + reach, kRowsOfTiles);
  const auto [lowest, highest] = heights_of(ground);
  if (!(lowest <= highest)) throw std::invalid_argument("the map has no drivable ground");
  first_z = lowest - (reach_up + 0.5) * height;  // The lowest ground is in the middle of a plane.
  planes = plane_of(highest) + 1 + reach_up;
  const std::int64_t rows = static_cast<std::int64_t>(planes) * pitch + 2 * reach;
  if (rows * (plane.width + 2 * reach) > kMostStackCells) {
    throw std::invalid_argument("a 3-D map is too large to be searched: use larger cells");
  }
}

}  // namespace castaway::localization
