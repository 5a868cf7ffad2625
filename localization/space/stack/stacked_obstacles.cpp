#include "localization/space/stack/stacked_obstacles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

constexpr double kGroundDepth = 0.12;  // [m] Nearer to a surface that faces up, a point is ground.
constexpr double kSpreadSigmas = 3.0;

bool is_ground(const ElevationMap& ground, const Eigen::Vector3d& p_map) {
  const GroundSurface* surface = surface_near(ground, p_map.head<2>(), p_map.z());
  return surface != nullptr &&
         std::abs(static_cast<double>(surface->z) - p_map.z()) <= kGroundDepth;
}

/// The lowest drivable ground above a point: nothing below it is seen from it. Null: none is above.
const GroundSurface* ground_above(const ElevationMap& ground, const Eigen::Vector3d& p_map) {
  const Eigen::Vector2d p_grid =
      ground.frame.T_map_grid.inverse() * Eigen::Vector2d(p_map.head<2>());
  for (const GroundSurface& surface : ground.at(ground.frame.cell_of(p_grid))) {
    if (surface.drivable && static_cast<double>(surface.z) > p_map.z()) return &surface;
  }
  return nullptr;
}

/// The cells around a position along one axis, with the squared distances to them. [m^2]
struct NearCells {
  NearCells(double position, double edge, double reach, int cells) {
    first = std::max(0, cell_index((position - reach) / edge));
    last = std::min(cells - 1, cell_index((position + reach) / edge));
    for (int cell = first; cell <= last; ++cell) {
      const double away = std::max({0.0, cell * edge - position, position - (cell + 1) * edge});
      squares.push_back(away * away);
    }
  }
  [[nodiscard]] double square(int cell) const {
    return squares[static_cast<std::size_t>(cell - first)];
  }

  int first;
  int last;
  std::vector<double> squares;
};

/// Bytes by squared distance.
class ByteTable {
 public:
  explicit ByteTable(double sigma) : limit_(kSpreadSigmas * sigma * kSpreadSigmas * sigma) {
    for (std::size_t i = 0; i < kSize; ++i) {
      const double square = limit_ * static_cast<double>(i) / kSize;
      bytes_[i] =
          static_cast<std::uint8_t>(std::lround(255.0 * std::exp(-0.5 * square / (sigma * sigma))));
    }
  }
  [[nodiscard]] std::uint8_t at(double square) const {
    if (square >= limit_) return 0;
    return bytes_[static_cast<std::size_t>(square / limit_ * kSize)];
  }

 private:
  static constexpr std::size_t kSize = 1024;

  double limit_;
  std::array<std::uint8_t, kSize> bytes_{};
};

/// Raises bytes around obstacles.
class Spreader {
 public:
  Spreader(const StackFrame& stack, double sigma)
      : stack_(stack),
        grid_(stack.grid()),
        table_(sigma),
        reach_(kSpreadSigmas * sigma),
        bytes_(grid_.size(), 0) {}

  /// `p`: in the frame of the grid, from the lower edge of the lowest plane. [m] Planes from
  /// `end_plane` on do not see it.
  void add(const Eigen::Vector3d& p, int end_plane) {
    const NearCells columns(p.x(), stack_.plane.resolution, reach_, stack_.plane.width);
    const NearCells rows(p.y(), stack_.plane.resolution, reach_, stack_.plane.height);
    const NearCells planes(p.z(), stack_.height, reach_, stack_.planes);
    for (int plane = planes.first; plane <= std::min(planes.last, end_plane - 1); ++plane) {
      for (int row = rows.first; row <= rows.last; ++row) {
        raise(plane, row, planes.square(plane) + rows.square(row), columns);
      }
    }
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void raise(int plane, int row, double square, const NearCells& columns) {
    const std::size_t first = grid_.index(stack_.stacked({0, row}, plane));
    for (int column = columns.first; column <= columns.last; ++column) {
      std::uint8_t& byte = bytes_[first + static_cast<std::size_t>(column)];
      if (byte == 255) continue;
      byte = std::max(byte, table_.at(square + columns.square(column)));
    }
  }

  const StackFrame& stack_;
  GridFrame grid_;
  ByteTable table_;
  double reach_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> stack_obstacles(const VoxelMap& voxels, const ElevationMap& ground,
                                          const StackFrame& stack, double sigma) {
  Spreader spreader(stack, sigma);
  const SE2 T_grid_map = stack.plane.T_map_grid.inverse();
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const Eigen::Vector3d p_map = voxels.point(i);
    if (is_ground(ground, p_map)) continue;
    const Eigen::Vector2d p_grid = T_grid_map * Eigen::Vector2d(p_map.head<2>());
    const GroundSurface* above = ground_above(ground, p_map);
    const int end_plane =
        above != nullptr ? stack.plane_of(static_cast<double>(above->z)) : stack.planes;
    spreader.add({p_grid.x(), p_grid.y(), p_map.z() - stack.first_z}, end_plane);
  }
  return spreader.take();
}

}  // namespace castaway::localization
