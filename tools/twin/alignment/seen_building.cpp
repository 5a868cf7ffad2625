#include "tools/twin/alignment/seen_building.hpp"

#include <algorithm>
#include <cmath>

#include "localization/map/distance_field.hpp"
#include "tools/twin/alignment/beam_view.hpp"
#include "tools/twin/alignment/seen_cells.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kBuildingScans = 4000;
constexpr double kFineCell = 0.025;           // [m]
constexpr std::size_t kMostCells = 32000000;  // Of the building.
constexpr double kBetweenBeams = 0.5;         // Cells of the building.
constexpr std::int8_t kOccupied = 100;
constexpr std::int8_t kFree = 0;

/// Cells of the building along an edge of a map's cell.
int subdivision(const RosMap& map) {
  const auto cells = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  const auto most =
      static_cast<int>(std::sqrt(static_cast<double>(kMostCells) / static_cast<double>(cells)));
  return std::clamp(static_cast<int>(std::ceil(map.resolution / kFineCell - 1e-6)), 1,
                    std::max(most, 1));
}

localization::GridFrame fine_frame(const localization::GridFrame& frame, int parts) {
  localization::GridFrame fine = frame;
  fine.width *= parts;
  fine.height *= parts;
  fine.resolution /= parts;
  return fine;
}

/// True if four successive ends lie on a line, within the noise of a lidar: what is between them is
/// a surface.
bool are_on_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                 const Eigen::Vector2d& d, double tolerance) {
  const Eigen::Vector2d along = d - a;
  const double length = along.norm();
  if (length < 1e-9) return false;
  const Eigen::Vector2d normal(-along.y() / length, along.x() / length);
  return std::abs(normal.dot(b - a)) < tolerance && std::abs(normal.dot(c - a)) < tolerance &&
         (c - b).norm() < 0.6 * length;
}

/// Beams of a scan in cells of the building, with more between those that end on one surface, so
/// that their ends leave no gaps.
std::vector<SeenCells::Beam> dense_beams(const std::vector<BeamView>& views, double parts,
                                         double resolution) {
  constexpr double kTolerance = 0.04;  // [m]
  std::vector<SeenCells::Beam> beams;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const BeamView& view = views[i];
    beams.push_back({parts * view.from, parts * view.end, view.returns});
    if (i < 1 || i + 2 >= views.size()) continue;
    const BeamView& next = views[i + 1];
    const bool surface = views[i - 1].returns && view.returns && next.returns &&
                         views[i + 2].returns &&
                         are_on_line(views[i - 1].end, view.end, next.end, views[i + 2].end,
                                     kTolerance / resolution);
    if (!surface) continue;
    const auto count = static_cast<int>(parts * (next.end - view.end).norm() / kBetweenBeams);
    for (int k = 1; k <= count; ++k) {
      const double share = static_cast<double>(k) / (count + 1);
      beams.push_back({parts * (view.from + share * (next.from - view.from)),
                       parts * (view.end + share * (next.end - view.end)), true});
    }
  }
  return beams;
}

/// Counts what the scans of a log saw in the cells of the building.
SeenCells see_all(const AlignedLog& log, const localization::GridFrame& fine) {
  const BeamViewer viewer(log);
  SeenCells seen(fine);
  const double resolution = log.grid.frame.resolution;
  for (const std::size_t i : spread_scans(log, kBuildingScans)) {
    seen.add_scan(dense_beams(viewer.view(log.scans[i]), resolution / fine.resolution, resolution),
                  1.0);
  }
  return seen;
}

/// Occupancy of a cell of the building. `occupancy`: of the map there; `off_wall` [m]: distance to
/// its walls.
std::int8_t occupancy_of(const SeenCells& seen, std::size_t index, std::int8_t occupancy,
                         double off_wall) {
  constexpr int kFewest = 2;  // Scans.
  const int returns = seen.returns(index);
  const int passes = seen.passes(index);
  if (off_wall == 0.0) return passes >= kFewest && passes > 2 * returns ? kFree : occupancy;
  const bool walkable = occupancy == kFree && off_wall > kCloseToWall;
  const int needed = walkable ? kFewest : 1;
  return returns >= needed && returns > passes ? kOccupied : occupancy;
}

}  // namespace

RosMap see_building(const RosMap& map, const AlignedLog& log) {
  const int parts = subdivision(map);
  const localization::GridFrame fine = fine_frame(log.grid.frame, parts);
  const SeenCells seen = see_all(log, fine);
  const localization::DistanceField distances(log.grid, 1.0);
  RosMap building = map;
  building.width = fine.width;
  building.height = fine.height;
  building.resolution = fine.resolution;
  building.cells.clear();
  for (int row = 0; row < fine.height; ++row) {
    for (int column = 0; column < fine.width; ++column) {
      const Eigen::Vector2d p_grid = fine.resolution * Eigen::Vector2d(column + 0.5, row + 0.5);
      building.cells.push_back(occupancy_of(seen, fine.index({column, row}),
                                            map.at(column / parts, row / parts),
                                            distances.at(p_grid)));
    }
  }
  return building;
}

}  // namespace castaway::testbed
