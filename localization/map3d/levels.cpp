#include "localization/map3d/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace castaway::localization {
namespace {

constexpr float kStep = 0.03F;       // [m] Between neighbouring cells of one floor.
constexpr float kBelowFloor = 0.3F;  // [m] A floor's own unevenness, and sills.
constexpr std::size_t kMostLevels = 255;

/// A floor: connected level surfaces.
struct Floor {
  double height = 0.0;  ///< [m] Mean.
  double area = 0.0;    ///< [m^2]
};

/// Walks over the level surfaces of a map.
class FloorFinder {
 public:
  FloorFinder(const ElevationMap& map, double slope)
      : map_(map), slope_(slope), seen_(map.surfaces.size(), false) {}

  /// The floor that a surface belongs to; nothing if it is not level, or was seen before.
  std::optional<Floor> from(const Eigen::Vector2i& cell, std::size_t surface) {
    if (!enters(surface)) return std::nullopt;
    Floor floor;
    std::size_t count = 0;
    open_.assign(1, {cell, surface});
    while (!open_.empty()) {
      const auto [at, index] = open_.back();
      open_.pop_back();
      floor.height += static_cast<double>(map_.surfaces[index].z);
      ++count;
      for (const Eigen::Vector2i& step : kSteps) open_neighbour(at + step, index);
    }
    floor.height /= static_cast<double>(count);
    floor.area = static_cast<double>(count) * map_.frame.resolution * map_.frame.resolution;
    return floor;
  }

 private:
  static inline const std::array<Eigen::Vector2i, 4> kSteps{
      Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0), Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)};

  bool enters(std::size_t index) {
    const GroundSurface& surface = map_.surfaces[index];
    const auto slope = static_cast<double>(std::hypot(surface.slope_x, surface.slope_y));
    if (seen_[index] || !surface.drivable || slope > slope_) return false;
    seen_[index] = true;
    return true;
  }
  void open_neighbour(const Eigen::Vector2i& cell, std::size_t from) {
    if (!map_.frame.contains(cell)) return;
    const std::size_t i = map_.frame.index(cell);
    for (std::size_t index = map_.first[i]; index < map_.first[i + 1]; ++index) {
      if (std::abs(map_.surfaces[index].z - map_.surfaces[from].z) > kStep) continue;
      if (enters(index)) open_.emplace_back(cell, index);
    }
  }

  const ElevationMap& map_;
  double slope_;
  std::vector<bool> seen_;
  std::vector<std::pair<Eigen::Vector2i, std::size_t>> open_;
};

/// Heights of the floors, ascending; floors of nearly one height are joined by their area.
std::vector<float> join_floors(std::vector<Floor> floors, double height) {
  std::ranges::sort(floors, {}, &Floor::height);
  std::vector<Floor> joined;
  for (const Floor& floor : floors) {
    if (!joined.empty() && floor.height - joined.back().height < height) {
      Floor& below = joined.back();
      const double area = below.area + floor.area;
      below.height = (below.height * below.area + floor.height * floor.area) / area;
      below.area = area;
    } else if (joined.size() < kMostLevels) {
      joined.push_back(floor);
    }
  }
  std::vector<float> heights;
  for (const Floor& floor : joined) heights.push_back(static_cast<float>(floor.height));
  return heights;
}

float lowest_ground(const ElevationMap& map) {
  float lowest = std::numeric_limits<float>::infinity();
  for (const GroundSurface& surface : map.surfaces) {
    if (surface.drivable) lowest = std::min(lowest, surface.z);
  }
  return std::isfinite(lowest) ? lowest : 0.0F;
}

}  // namespace

void label_levels(ElevationMap& map, const LevelConfig& config) {
  FloorFinder finder(map, config.slope);
  std::vector<Floor> floors;
  for (int y = 0; y < map.frame.height; ++y) {
    for (int x = 0; x < map.frame.width; ++x) {
      const std::size_t cell = map.frame.index({x, y});
      for (std::size_t i = map.first[cell]; i < map.first[cell + 1]; ++i) {
        const auto floor = finder.from({x, y}, i);
        if (floor && floor->area >= config.area) floors.push_back(*floor);
      }
    }
  }
  map.levels = join_floors(std::move(floors), config.height);
  if (map.levels.empty()) map.levels.push_back(lowest_ground(map));
  for (GroundSurface& surface : map.surfaces) {
    const auto above = std::ranges::upper_bound(map.levels, surface.z + kBelowFloor);
    const auto count = std::max<std::ptrdiff_t>(above - map.levels.begin(), 1);
    surface.level = static_cast<std::uint8_t>(count - 1);
  }
}

}  // namespace castaway::localization
