#include "sim/map/places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace castaway::sim {
namespace {

constexpr double kRoundingMargin = 1e-6;  // [m] For rounding.

}  // namespace

std::vector<Eigen::Vector2d> even_places(const FreeSpace& free, double spacing) {
  const Grid& grid = free.grid();
  const int stride = std::max(1, static_cast<int>(std::lround(spacing / grid.resolution)));
  std::vector<Eigen::Vector2d> places;
  for (int row = stride / 2; row < grid.height; row += stride) {
    for (int column = stride / 2; column < grid.width; column += stride) {
      if (grid.at(column, row) == Cell::kFree) places.push_back(center_of(grid, {column, row}));
    }
  }
  return places;
}

RayScene level_scene(const WorldSpec& world, double z) {
  std::vector<RayPrimitive> primitives = ray_primitives(world);
  std::erase_if(primitives, [z](const RayPrimitive& primitive) {
    const Eigen::AlignedBox3d box = bounds(primitive);
    return box.min().z() > z + kRoundingMargin || box.max().z() < z - kRoundingMargin;
  });
  return RayScene(std::move(primitives));
}

std::vector<float> scan_at(const RayScene& scene, const Eigen::Vector2d& p_map, double heading,
                           const PlaceView& view) {
  std::vector<float> ranges;
  ranges.reserve(static_cast<std::size_t>(view.beams));
  std::uint32_t guess = kNoPrimitive;
  for (int i = 0; i < view.beams; ++i) {
    const double angle = heading + 2.0 * std::numbers::pi * i / view.beams;
    const Ray ray{{p_map.x(), p_map.y(), view.z}, {std::cos(angle), std::sin(angle), 0.0}};
    const auto hit = scene.cast(ray, view.range_max, guess);
    if (hit) guess = hit->primitive;
    ranges.push_back(static_cast<float>(hit ? hit->distance : view.range_max));
  }
  return ranges;
}

}  // namespace castaway::sim
