#include "sim/map/level_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace castaway::sim {
namespace {

constexpr double kMostAbove = 1.0;  // [m] Ground farther above or below is not what one stands on.

/// Finds the parts of a plane's own free cells, one after another.
class PartSearch {
 public:
  PartSearch(const LevelPlane& plane, const Grid& free)
      : plane_(plane), free_(free), part_(free.cells.size(), -1) {}

  /// Marks the part of a cell; returns its number of cells.
  std::size_t fill(std::size_t from, int part) {
    std::size_t count = 0;
    take(from, part);
    while (!open_.empty()) {
      const CellIndex cell = cell_at_index(free_, open_.back());
      open_.pop_back();
      ++count;
      for (const CellIndex& step : kSteps) {
        const CellIndex next{cell.column + step.column, cell.row + step.row};
        if (free_.contains(next.column, next.row)) take_own(flat_index(free_, next), part);
      }
    }
    return count;
  }

  /// True for a free cell that belongs to its chart and to no part yet.
  [[nodiscard]] bool is_new(std::size_t cell) const {
    return part_[cell] < 0 && free_.cells[cell] == Cell::kFree && plane_.is_own(cell);
  }
  [[nodiscard]] const std::vector<int>& parts() const { return part_; }

 private:
  static constexpr std::array<CellIndex, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

  void take_own(std::size_t cell, int part) {
    const std::int32_t own = plane_.cells[cell].own;
    if (own >= 0 && is_new(static_cast<std::size_t>(own)))
      take(static_cast<std::size_t>(own), part);
  }
  void take(std::size_t cell, int part) {
    part_[cell] = part;
    open_.push_back(cell);
  }

  const LevelPlane& plane_;
  const Grid& free_;
  std::vector<int> part_;
  std::vector<std::size_t> open_;
};

}  // namespace

const LevelCell* LevelPlane::at(const Eigen::Vector2d& p_plane) const {
  const CellIndex cell = cell_of(grid, p_plane);
  return grid.contains(cell.column, cell.row) ? &cells[flat_index(grid, cell)] : nullptr;
}

Pose2 LevelPlane::in_map(const Pose2& T_plane_base) const {
  const int row = std::clamp(cell_of(grid, T_plane_base.position()).row, 0, grid.height - 1);
  const int first_row = row - row % stride;
  const double shift = first_row * grid.resolution;
  return {T_plane_base.x, T_plane_base.y - shift, T_plane_base.yaw};
}

std::optional<Pose2> LevelPlane::on_plane(const Pose2& T_map_base, double z) const {
  const auto found = nearest_ground(T_map_base, z);
  if (!found) return std::nullopt;
  const LevelCell* cell = at(found->position());
  return std::abs(static_cast<double>(cell->z) - z) < kMostAbove ? found : std::nullopt;
}

std::optional<Pose2> LevelPlane::nearest_ground(const Pose2& T_map_base, double z) const {
  const CellIndex first = cell_of(grid, T_map_base.position());
  if (!grid.contains(first.column, first.row) || first.row >= stride) return std::nullopt;
  std::optional<Pose2> best;
  double least = std::numeric_limits<double>::infinity();
  for (int row = first.row; row < grid.height; row += stride) {
    const std::size_t cell = flat_index(grid, {first.column, row});
    const double away = std::abs(static_cast<double>(cells[cell].z) - z);
    if (!is_own(cell) || away >= least) continue;
    least = away;
    best = {T_map_base.x, T_map_base.y + (row - first.row) * grid.resolution, T_map_base.yaw};
  }
  return best;
}

std::optional<Pose2> LevelPlane::on_level(const Pose2& T_map_base, std::optional<int> level) const {
  const CellIndex first = cell_of(grid, T_map_base.position());
  if (!grid.contains(first.column, first.row) || first.row >= stride) return std::nullopt;
  std::optional<Pose2> best;
  float lowest = std::numeric_limits<float>::infinity();
  for (int row = first.row; row < grid.height; row += stride) {
    const std::size_t cell = flat_index(grid, {first.column, row});
    const bool wanted = !level || *level == cells[cell].level;
    if (!is_own(cell) || !wanted || cells[cell].z >= lowest) continue;
    lowest = cells[cell].z;
    best = {T_map_base.x, T_map_base.y + (row - first.row) * grid.resolution, T_map_base.yaw};
  }
  return best;
}

Eigen::Vector3d LevelPlane::p_map(const Eigen::Vector2d& p_plane) const {
  const Pose2 T_map_point = in_map({p_plane.x(), p_plane.y(), 0.0});
  const LevelCell* cell = at(p_plane);
  if (cell == nullptr || cell->own < 0) return {T_map_point.x, T_map_point.y, 0.0};
  const Eigen::Vector2d off = p_plane - center_of(grid, cell_of(grid, p_plane));
  const double z = cell->z + cell->slope_x * off.x() + cell->slope_y * off.y();
  return {T_map_point.x, T_map_point.y, z};
}

Eigen::Isometry3d LevelPlane::standing_at(const Pose2& T_plane_base) const {
  const LevelCell* cell = at(T_plane_base.position());
  const bool ground = cell != nullptr && cell->own >= 0;
  const Eigen::Vector3d up =
      ground ? Eigen::Vector3d(-cell->slope_x, -cell->slope_y, 1.0) : Eigen::Vector3d::UnitZ();
  // The heading is kept as seen from above: pitch first, then roll.
  const Eigen::Vector2d heading(std::cos(T_plane_base.yaw), std::sin(T_plane_base.yaw));
  const double rise = -heading.dot(up.head<2>());
  const Eigen::Vector3d x = Eigen::Vector3d(heading.x(), heading.y(), rise).normalized();
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d z = up.normalized();
  T_map_base.linear().col(0) = x;
  T_map_base.linear().col(1) = z.cross(x);
  T_map_base.linear().col(2) = z;
  T_map_base.translation() = p_map(T_plane_base.position());
  return T_map_base;
}

double LevelPlane::slope_at(const Eigen::Vector2d& p_plane) const {
  const LevelCell* cell = at(p_plane);
  return cell != nullptr ? std::hypot(cell->slope_x, cell->slope_y) : 0.0;
}

Grid largest_part(const LevelPlane& plane, Grid eroded) {
  PartSearch search(plane, eroded);
  int parts = 0;
  int largest = -1;
  std::size_t most = 0;
  for (std::size_t i = 0; i < eroded.cells.size(); ++i) {
    if (!search.is_new(i)) continue;
    const std::size_t count = search.fill(i, parts);
    if (count > most) largest = parts;
    most = std::max(most, count);
    ++parts;
  }
  for (std::size_t i = 0; i < eroded.cells.size(); ++i) {
    if (eroded.cells[i] == Cell::kFree && (largest < 0 || search.parts()[i] != largest)) {
      eroded.cells[i] = Cell::kUnknown;
    }
  }
  return eroded;
}

}  // namespace castaway::sim
