#include "tools/twin/alignment/expected_scan.hpp"

#include <algorithm>
#include <cmath>

#include "localization/map/ray_cast.hpp"

namespace castaway::testbed {
namespace {

/// End points of the expected beams. [m] In the grid's frame.
using EndPoints = std::vector<Eigen::Vector2d>;

constexpr double kHalfWall = 0.15;  // [m] of wall on either side of a beam
constexpr double kSagitta = 0.04;   // [m] Largest distance of a straight wall from its chord.

/// The farthest neighbour of a beam in one direction that is needed for `kHalfWall`; the beam
/// itself if the wall ends before.
std::size_t neighbour(const std::vector<ExpectedBeam>& beams, const EndPoints& ends, std::size_t i,
                      int direction) {
  std::size_t k = i;
  while ((ends[k] - ends[i]).norm() < kHalfWall) {
    if (direction < 0 ? k == 0 : k + 1 == beams.size()) return i;
    k = direction < 0 ? k - 1 : k + 1;
    if (!beams[k].wall || (ends[k] - ends[i]).norm() > 6.0 * kHalfWall) return i;
  }
  return k;
}

void find_incidence(const EndPoints& ends, std::size_t i, const Eigen::Vector2d& direction,
                    std::vector<ExpectedBeam>& beams) {
  if (!beams[i].wall) return;
  const std::size_t a = neighbour(beams, ends, i, -1);
  const std::size_t b = neighbour(beams, ends, i, 1);
  if (a == i || b == i) return;
  const Eigen::Vector2d along = (ends[b] - ends[a]).normalized();
  const Eigen::Vector2d normal(-along.y(), along.x());
  for (std::size_t k = a; k <= b; ++k) {
    if (std::abs(normal.dot(ends[k] - ends[a])) > kSagitta) return;
  }
  beams[i].straight = true;
  beams[i].cosine = static_cast<float>(std::abs(normal.dot(direction)));
}

/// The occupied cell in which a ray ends; nothing if it is not occupied.
std::optional<std::size_t> wall_at(const localization::OccupancyGrid& grid,
                                   const Eigen::Vector2d& p_cells,
                                   const Eigen::Vector2d& direction) {
  constexpr double kInto = 1e-3;  // cells
  const Eigen::Vector2d p = p_cells + kInto * direction;
  const Eigen::Vector2i cell(static_cast<int>(std::floor(p.x())),
                             static_cast<int>(std::floor(p.y())));
  if (!grid.frame.contains(cell)) return std::nullopt;
  const std::size_t index = grid.frame.index(cell);
  if (grid.cells[index] != localization::CellState::kOccupied) return std::nullopt;
  return index;
}

}  // namespace

std::vector<ExpectedBeam> expect_scan(const AlignedLog& log, const AlignedScan& aligned,
                                      double longest) {
  const LaserScan& scan = aligned.scan;
  const localization::GridFrame& frame = log.grid.frame;
  const auto T_path_first = log.T_path_base.at(scan.stamp);
  if (!T_path_first) return {};
  const SE2 T_grid_path = frame.T_map_grid.inverse() * aligned.T_map_base * T_path_first->inverse();
  std::vector<ExpectedBeam> beams(scan.ranges.size());
  EndPoints ends(beams.size());
  EndPoints directions(beams.size());
  SE2 T_path_base = *T_path_first;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (scan.time_increment != Stamp::zero()) {
      const auto at = log.T_path_base.at(scan.beam_stamp(i));
      if (!at) return {};
      T_path_base = *at;
    }
    const Eigen::Isometry3d T_grid_laser =
        localization::to_se3(T_grid_path * T_path_base) * scan.T_base_laser;
    const double angle = scan.beam_angle(i);
    const Eigen::Vector3d d =
        T_grid_laser.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    directions[i] = d.head<2>().normalized();
    const Eigen::Vector2d from = T_grid_laser.translation().head<2>() / frame.resolution;
    const double cells =
        localization::cast_ray(log.grid, from, directions[i], longest / frame.resolution);
    const Eigen::Vector2d end = from + cells * directions[i];
    ends[i] = end * frame.resolution;
    beams[i].range = static_cast<float>(cells * frame.resolution);
    const auto cell = wall_at(log.grid, end, directions[i]);
    beams[i].wall = cell && beams[i].range < longest;
    beams[i].cell = cell.value_or(0);
  }
  for (std::size_t i = 0; i < beams.size(); ++i) find_incidence(ends, i, directions[i], beams);
  return beams;
}

std::vector<std::size_t> spread_scans(const AlignedLog& log, std::size_t most) {
  return localization::even_indices(log.scans.size(), static_cast<int>(most));
}

}  // namespace castaway::testbed
