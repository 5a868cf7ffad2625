#include "localization/space/map3d/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace castaway::localization {
namespace {

constexpr std::uint32_t kNoCell = std::numeric_limits<std::uint32_t>::max();
constexpr float kLedge = 0.06F;    // [m] Between neighbouring cells of one chart.
constexpr double kBetween = 10.0;  // [m] More than any search for a place near by reaches.
constexpr std::int64_t kMostRows = 1 << 24;

}  // namespace

Atlas::Atlas(ElevationMap ground, double margin) : ground_(std::move(ground)) {
  validate(ground_);
  const double edge = ground_.frame.resolution;
  const std::vector<Chart> charts =
      cut_charts(ground_, kLedge, static_cast<int>(std::ceil(margin / edge)));
  if (charts.empty()) throw std::invalid_argument("the map has no drivable ground");
  stride_ = ground_.frame.height + static_cast<int>(std::ceil(kBetween / edge));
  if (static_cast<std::int64_t>(charts.size()) * stride_ > kMostRows) {
    throw std::invalid_argument("the ground has too many parts; use a larger voxel");
  }
  charts_ = static_cast<int>(charts.size());
  frame_ = ground_.frame;
  T_grid_atlas_ = localization::grid_from_map(ground_);
  frame_.height = (charts_ - 1) * stride_ + ground_.frame.height;
  surfaces_.assign(frame_.size(), -1);
  own_cells_.assign(ground_.surfaces.size(), kNoCell);
  for (int i = 0; i < charts_; ++i) place(charts[static_cast<std::size_t>(i)], i * stride_);
}

void Atlas::place(const Chart& chart, int first_row) {
  const auto cell_of = [&](const SurfaceAt& at) {
    return frame_.index({at.cell.x(), at.cell.y() + first_row});
  };
  for (const SurfaceAt& at : chart.margin) {
    surfaces_[cell_of(at)] = static_cast<std::int32_t>(at.index);
  }
  for (const SurfaceAt& at : chart.own) {
    surfaces_[cell_of(at)] = static_cast<std::int32_t>(at.index);
    own_cells_[at.index] = static_cast<std::uint32_t>(cell_of(at));
  }
}

const GroundSurface* Atlas::surface_at(const Eigen::Vector2i& cell) const {
  if (!frame_.contains(cell)) return nullptr;
  const std::int32_t index = surfaces_[frame_.index(cell)];
  return index < 0 ? nullptr : &ground_.surfaces[static_cast<std::size_t>(index)];
}

bool Atlas::is_own(const Eigen::Vector2i& cell) const {
  if (!frame_.contains(cell)) return false;
  const std::size_t i = frame_.index(cell);
  return surfaces_[i] >= 0 && own_cells_[static_cast<std::size_t>(surfaces_[i])] == i;
}

Eigen::Vector2i Atlas::own_cell(const Eigen::Vector2i& cell) const {
  if (surface_at(cell) == nullptr) return cell;
  const auto surface = static_cast<std::size_t>(surfaces_[frame_.index(cell)]);
  const auto own = static_cast<int>(own_cells_[surface]);
  return {own % frame_.width, own / frame_.width};
}

/// A translation by rows of the grid, as one of map. [m]
Eigen::Vector2d Atlas::along_rows(int rows) const {
  if (rows == 0) return Eigen::Vector2d::Zero();
  const SE2 turn{0.0, 0.0, frame_.T_map_grid.yaw};
  return turn * Eigen::Vector2d(0.0, rows * frame_.resolution);
}

Eigen::Vector2i Atlas::cell_of(const SE2& T_atlas_base) const {
  return frame_.cell_of(T_grid_atlas_ * T_atlas_base.translation());
}

SE2 Atlas::in_map(const SE2& T_atlas_base) const {
  return in_map(T_atlas_base, cell_of(T_atlas_base));
}

SE2 Atlas::in_map(const SE2& T_atlas_base, const Eigen::Vector2i& cell) const {
  const int chart = std::clamp(cell.y() / stride_, 0, charts_ - 1);
  const Eigen::Vector2d shift = along_rows(-chart * stride_);
  return {T_atlas_base.x + shift.x(), T_atlas_base.y + shift.y(), T_atlas_base.yaw};
}

std::optional<GroundPose> Atlas::to_map(const SE2& T_atlas_base) const {
  const Eigen::Vector2i cell = cell_of(T_atlas_base);
  const GroundSurface* surface = surface_at(cell);
  if (surface == nullptr) return std::nullopt;
  return GroundPose{in_map(T_atlas_base, cell), surface};
}

std::optional<SE2> Atlas::to_atlas(const SE2& T_map_base, double z) const {
  const Eigen::Vector2i cell =
      ground_.frame.cell_of(ground_.frame.T_map_grid.inverse() * T_map_base.translation());
  if (!ground_.frame.contains(cell)) return std::nullopt;
  std::uint32_t own = kNoCell;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t i = ground_.frame.index(cell);
  for (std::size_t index = ground_.first[i]; index < ground_.first[i + 1]; ++index) {
    const double away = std::abs(static_cast<double>(ground_.surfaces[index].z) - z);
    if (own_cells_[index] == kNoCell || away >= least) continue;
    least = away;
    own = own_cells_[index];
  }
  if (own == kNoCell) return std::nullopt;
  const int row = static_cast<int>(own) / frame_.width;
  const Eigen::Vector2d shift = along_rows(row - cell.y());
  return SE2{T_map_base.x + shift.x(), T_map_base.y + shift.y(), T_map_base.yaw};
}

Eigen::Vector2d Atlas::to_own_chart(const SE2& T_atlas_base) const {
  const Eigen::Vector2i cell = cell_of(T_atlas_base);
  return along_rows(own_cell(cell).y() - cell.y());
}

}  // namespace castaway::localization
