#include "localization/space/ndt/ndt_map.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace castaway::localization {
namespace {

constexpr double kMostNdtCells = 1 << 28;

std::vector<Eigen::Vector3f> centres(const OccupancyGrid& grid) {
  std::vector<Eigen::Vector3f> points;
  for (int row = 0; row < grid.frame.height; ++row) {
    for (int column = 0; column < grid.frame.width; ++column) {
      const Eigen::Vector2i cell(column, row);
      if (grid.cells[grid.frame.index(cell)] != CellState::kOccupied) continue;
      const Eigen::Vector2d p_map = grid.frame.T_map_grid * grid.frame.centre_of(cell);
      points.emplace_back(static_cast<float>(p_map.x()), static_cast<float>(p_map.y()), 0.0F);
    }
  }
  return points;
}

std::vector<Eigen::Vector3f> surface_points(const VoxelMap& voxels) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) points.push_back(voxels.point(i).cast<float>());
  return points;
}

}  // namespace

void validate(const NdtConfig& config) {
  if (!(config.cell >= 0.05 && config.cell <= 10.0)) {
    throw std::invalid_argument("ndt cell must be 0.05 to 10 m");
  }
  if (!(config.along >= 1.0 && config.along <= 100.0)) {
    throw std::invalid_argument("ndt along must be 1 to 100");
  }
}

NdtMap::NdtMap(const OccupancyGrid& grid, const NdtConfig& config)
    : NdtMap(centres(grid), grid.frame.resolution, config, true) {}

NdtMap::NdtMap(const VoxelMap& voxels, const NdtConfig& config)
    : NdtMap(surface_points(voxels), voxels.resolution / 4.0, config, false) {}

NdtMap::NdtMap(std::vector<Eigen::Vector3f> points, double spacing, const NdtConfig& config,
               bool planar)
    : planar_(planar), lattice_(lattice_around(points, (validate(config), config.cell))) {
  std::vector<std::pair<std::size_t, Eigen::Vector3f>> by_cell;
  by_cell.reserve(points.size());
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3f at = lattice_.per_m * (p - lattice_.origin);
    const Eigen::Vector3i last = lattice_.size.array() - 1;
    by_cell.emplace_back(lattice_.index(at.array().floor().matrix().cast<int>().cwiseMin(last)), p);
  }
  std::stable_sort(by_cell.begin(), by_cell.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::size_t> cells;
  cells.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = by_cell[i].second;
    cells.push_back(by_cell[i].first);
  }
  fit(points, cells, {spacing, config.along, planar});
}

NdtMap::Lattice NdtMap::lattice_around(const std::vector<Eigen::Vector3f>& points, double cell) {
  Lattice lattice;
  lattice.per_m = static_cast<float>(1.0 / cell);
  if (points.empty()) return lattice;
  Eigen::Vector3f low = points.front();
  Eigen::Vector3f high = points.front();
  for (const Eigen::Vector3f& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  lattice.origin = low;
  const Eigen::Array3f cells = (lattice.per_m * (high - low)).array().floor() + 1.0F;
  if (static_cast<double>(cells.prod()) > kMostNdtCells) {
    throw std::invalid_argument("the map is too large for its cells of ndt; use a larger ndt cell");
  }
  lattice.size = cells.matrix().cast<int>();
  return lattice;
}

void NdtMap::fit(std::vector<Eigen::Vector3f>& points, const std::vector<std::size_t>& cells,
                 const FitConfig& config) {
  const auto count = static_cast<std::size_t>(lattice_.size.cast<double>().prod());
  first_.reserve(count + 1);
  std::size_t begin = 0;
  for (std::size_t cell = 0; cell < count; ++cell) {
    first_.push_back(static_cast<std::uint32_t>(distributions_.size()));
    std::size_t end = begin;
    while (end < cells.size() && cells[end] == cell) ++end;
    if (end == begin) continue;
    const auto members = std::span(points).subspan(begin, end - begin);
    for (const FittedCell& part : fit_cell(members, config)) {
      distributions_.push_back(part.distribution);
    }
    begin = end;
  }
  first_.push_back(static_cast<std::uint32_t>(distributions_.size()));
}

std::size_t NdtMap::Lattice::index(const Eigen::Vector3i& cell) const {
  const Eigen::Matrix<std::size_t, 3, 1> c = cell.cast<std::size_t>();
  const Eigen::Matrix<std::size_t, 3, 1> s = size.cast<std::size_t>();
  return (c.z() * s.y() + c.y()) * s.x() + c.x();
}

std::span<const NormalDistribution> NdtMap::at(const Eigen::Vector3i& cell) const {
  if ((cell.array() < 0).any() || (cell.array() >= lattice_.size.array()).any()) return {};
  const std::size_t i = lattice_.index(cell);
  return std::span(distributions_).subspan(first_[i], first_[i + 1] - first_[i]);
}

}  // namespace castaway::localization
