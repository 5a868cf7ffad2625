#include "tools/play/observation/ground_items.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tools/play/observation/cell_mesh.hpp"
#include "tools/play/observation/observation_colors.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using Eigen::Vector3d;
using Eigen::Vector3f;
using localization::ElevationMap;
using localization::GroundSurface;

const Vector3f kLowColor{0.76F, 0.70F, 0.56F};
const Vector3f kContourColor{0.62F, 0.56F, 0.44F};
const Vector3f kVoxelColor{0.33F, 0.44F, 0.66F};
constexpr double kCellOverlap =
    1.1;                       // Of the cells of rolling ground, so that there are no cracks.
constexpr float kCube = 0.9F;  // Edge of a drawn voxel, in edges.
constexpr int kVerge = 3;      // [cells] Width of ground beside obstacles, too narrow to drive.
constexpr int kWidestObstacle = 20;   // [cells] Half of it: ground is searched so far.
constexpr float kMostStep = 0.3F;     // [m] Between a verge and drivable ground.
constexpr float kBuried = 0.15F;      // [m] Below the ground: not drawn.
constexpr float kContourStep = 0.5F;  // [m]
constexpr double kCeiling = 0.3;      // [m] Below what hangs over the robot.

/// [m] Above this, everything is left out: the next floor.
double top_of(const ElevationMap& ground, const MapWindow& window) {
  const GroundSurface* here = surface_near(ground, window.T_map_window.translation(), window.z);
  if (here == nullptr) return window.z;
  return static_cast<double>(here->z + here->clearance) - kCeiling;
}

/// Calls `take` with the surfaces of the cells that are `ring` cells from a cell.
template <typename Take>
void for_ring(const ElevationMap& map, const Vector2i& cell, int ring, const Take& take) {
  for (int dy = -ring; dy <= ring; ++dy) {
    const int step = std::abs(dy) == ring ? 1 : std::max(1, 2 * ring);
    for (int dx = -ring; dx <= ring; dx += step) {
      for (const GroundSurface& surface : map.at(cell + Vector2i(dx, dy))) take(surface);
    }
  }
}

/// [m] The lowest drivable ground of the nearest cells that have any; nothing if none is near.
std::optional<float> ground_beside(const ElevationMap& map, const Vector2i& cell) {
  std::optional<float> lowest;
  for (int ring = 0; ring <= kWidestObstacle && !lowest; ++ring) {
    for_ring(map, cell, ring, [&](const GroundSurface& surface) {
      if (surface.drivable) lowest = std::min(lowest.value_or(surface.z), surface.z);
    });
  }
  return lowest;
}

/// True for what nobody on the ground sees: undersides of obstacles, and a floor below the ground.
bool is_buried(const ElevationMap& ground, const Vector3d& p_map) {
  const Vector2d p_grid = ground.frame.T_map_grid.inverse() * Vector2d(p_map.head<2>());
  const auto z = ground_beside(ground, ground.frame.cell_of(p_grid));
  return z && p_map.z() < static_cast<double>(*z - kBuried);
}

/// True for drivable ground and its verges, not for the tops of obstacles.
bool is_ground(const ElevationMap& map, const Vector2i& cell, const GroundSurface& surface) {
  bool found = surface.drivable;
  for (int ring = 0; ring <= kVerge && !found; ++ring) {
    for_ring(map, cell, ring, [&](const GroundSurface& other) {
      found = found || (other.drivable && std::abs(other.z - surface.z) < kMostStep);
    });
  }
  return found;
}

/// Heights of the drivable ground in a window.
struct HeightRange {
  float low = 0.0F;   ///< [m]
  float high = 0.0F;  ///< [m]

  /// 0 for the lowest ground, 1 for the highest; where all is level, 1.
  [[nodiscard]] float share(float z) const {
    return (z - std::min(low, high - 1.0F)) / std::max(high - low, 1.0F);
  }
};

HeightRange height_range(const ElevationMap& ground, const MapWindow& window, double top) {
  HeightRange range{static_cast<float>(window.z), static_cast<float>(window.z)};
  for_cells(ground.frame, window, [&](const Vector2i& cell) {
    for (const GroundSurface& surface : ground.at(cell)) {
      if (!surface.drivable || static_cast<double>(surface.z) > top) continue;
      range.low = std::min(range.low, surface.z);
      range.high = std::max(range.high, surface.z);
    }
  });
  return range;
}

/// Adds the contour lines of a cell's plane.
void add_contours(const CellCorners& corners, sim::SceneLines& lines) {
  const auto [lowest, highest] =
      std::ranges::minmax(corners, {}, [](const Vector3f& p) { return p.z(); });
  const float first = kContourStep * std::ceil(lowest.z() / kContourStep);
  for (float z = first; z < highest.z(); z += kContourStep) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector3f& from = corners[i];
      const Vector3f& to = corners[(i + 1) % corners.size()];
      if ((from.z() < z) == (to.z() < z)) continue;
      lines.points.push_back(mix(from, to, (z - from.z()) / (to.z() - from.z())));
    }
  }
}

/// Adds the plane of a surface.
void add_surface(const localization::GridFrame& frame, const Vector2i& cell,
                 const GroundSurface& surface, const Vector3f& color, GroundItems& items) {
  const Vector2d slope(surface.slope_x, surface.slope_y);
  const Vector2d up = Eigen::Rotation2Dd(frame.T_map_grid.yaw) * -slope;
  const auto plane = [&](const Vector2d& p) {
    return static_cast<double>(surface.z) + slope.dot(p);
  };
  add_cell(cell_corners(frame, cell, kCellOverlap * frame.resolution, plane),
           sim::raise_point(up, 1.0).normalized(), color, items.surface.mesh);
  add_contours(cell_corners(frame, cell, frame.resolution, plane), items.contours);
}

void add_cube(const Vector3f& middle, float edge, sim::TriangleMesh& mesh) {
  const sim::TriangleMesh cube = sim::box_mesh(Vector3f::Constant(edge));
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3f& vertex : cube.vertices) mesh.vertices.push_back(middle + vertex);
  mesh.normals.insert(mesh.normals.end(), cube.normals.begin(), cube.normals.end());
  for (const std::uint32_t i : cube.indices) mesh.indices.push_back(first + i);
}

}  // namespace

GroundItems ground_items(const localization::Volume& volume,
                         const localization::EndpointConfig& model, const MapWindow& window,
                         double height) {
  GroundItems items;
  items.contours.color = kContourColor;
  const ElevationMap& ground = volume.atlas().ground();
  const double top = top_of(ground, window);
  const HeightRange range = height_range(ground, window, top);
  const auto color_of = [&](const Vector2i& cell, const GroundSurface& surface) -> Vector3f {
    if (!surface.drivable) return kCostColor;
    const Vector2d p_map = ground.frame.T_map_grid * ground.frame.centre_of(cell);
    const Vector3f p = sim::raise_point(p_map, static_cast<double>(surface.z) + height);
    return cost_color(model, static_cast<double>(volume.walls().at_point(p)),
                      mix(kLowColor, kFreeColor, range.share(surface.z)));
  };
  for_cells(ground.frame, window, [&](const Vector2i& cell) {
    for (const GroundSurface& surface : ground.at(cell)) {
      if (static_cast<double>(surface.z) > top || !is_ground(ground, cell, surface)) continue;
      add_surface(ground.frame, cell, surface, color_of(cell, surface), items);
    }
  });
  return items;
}

sim::SceneItem obstacles_item(const localization::Volume& volume, const MapWindow& window) {
  sim::SceneItem item;
  item.color = kVoxelColor;
  const ElevationMap& ground = volume.atlas().ground();
  const localization::VoxelMap voxels = without_ground(volume.voxels(), ground);
  const double top = top_of(ground, window);
  const auto edge = kCube * static_cast<float>(voxels.resolution);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const Vector3d p_map = voxels.point(i);
    if (!window.contains(p_map.head<2>()) || p_map.z() > top || is_buried(ground, p_map)) continue;
    add_cube(p_map.cast<float>(), edge, item.mesh);
  }
  return item;
}

}  // namespace castaway::testbed
