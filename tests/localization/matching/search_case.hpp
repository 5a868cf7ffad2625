/// Random maps and scans for tests of searches, small enough for naive loops.
#pragma once

#include <algorithm>

#include "localization/geometry/transform_buffer.hpp"
#include "localization/matching/branch_and_bound.hpp"
#include "tests/support/grid_world.hpp"

namespace castaway::test {

using namespace localization;  // test support of one library

/// A number in [low, high), a multiple of a thousandth of the span.
inline double uniform(double low, double high, Rng& rng) {
  return low + (high - low) * static_cast<double>(rng() % 1000) / 1000.0;
}

/// A room of random size with random boxes, at 10 cm.
inline OccupancyGrid random_room(Rng& rng) {
  OccupancyGrid grid;
  grid.frame = {30 + static_cast<int>(rng() % 50), 20 + static_cast<int>(rng() % 40), 0.1, {}};
  grid.cells.assign(grid.frame.size(), CellState::kOccupied);
  const double width = 0.1 * grid.frame.width;
  const double height = 0.1 * grid.frame.height;
  fill(grid, 0.15, 0.15, width - 0.15, height - 0.15, CellState::kFree);
  for (int k = 0; k < 5; ++k) {
    const double x = uniform(0.0, width, rng);
    const double y = uniform(0.0, height, rng);
    const CellState state = k == 0 ? CellState::kUnknown : CellState::kOccupied;
    fill(grid, x, y, x + uniform(0.1, 1.0, rng), y + uniform(0.1, 1.0, rng), state);
  }
  return grid;
}

/// A scan in base coordinates, taken in a room at a pose.
inline ScanPoints scan_from(const OccupancyGrid& grid, const SE2& pose, int beams) {
  TransformBuffer buffer;
  buffer.add(Stamp(0), {});
  return *project_scan(scan_at(grid, pose, Stamp(0), beams), buffer, Stamp(0), {});
}

/// A map prepared for searching.
struct SearchedMap {
  static constexpr int kYaws = 40;
  static constexpr int kPoints = 24;

  explicit SearchedMap(const OccupancyGrid& grid, int levels = 3)
      : field(grid, DistanceField(grid, 5.0), {0.2, 0.15, 9.0}),
        pyramid(make_pyramid(field, levels)) {}

  [[nodiscard]] SearchSpace space(const std::optional<MatchWindow>& window = {}) const {
    return search_space(field.frame(), kYaws, window);
  }
  [[nodiscard]] std::vector<std::vector<CellOffset>> rotate_scans(const ScanPoints& points,
                                                                  const SearchSpace& within) const {
    std::vector<std::vector<CellOffset>> scans;
    for (const int yaw : within.yaws) {
      scans.push_back(rotate_scan(points, kPoints, field.frame().resolution,
                                  yaw_of_step(yaw, kYaws), field.padding()));
    }
    return scans;
  }
  [[nodiscard]] BestPlaces best_places(int count) const {
    return {field.frame(), {4, 2}, count, 255 * kPoints};
  }

  ByteField field;
  Pyramid pyramid;
};

/// Value of a cell; 0 outside the map.
inline int byte_at(const ByteField& field, int column, int row) {
  return field.frame().contains({column, row}) ? *field.cell(column, row) : 0;
}

/// Score of a place, by naive lookups.
inline int naive_score(const ByteField& field, const std::vector<CellOffset>& scan, int column,
                       int row) {
  int sum = 0;
  for (const CellOffset& o : scan) sum += byte_at(field, column + o.dx, row + o.dy);
  return sum;
}

}  // namespace castaway::test
