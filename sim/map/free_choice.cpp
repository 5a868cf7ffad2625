#include "sim/map/free_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

// [m^2] Smaller enclosed parts are never preferred to one at the edge.
constexpr double kSizeable = 1.0;
constexpr double kRoom = 10.0;  // [m^2] Smaller rooms are not what a map is about.
// An enclosed part with this share of the area of the part at the edge is preferred.
constexpr double kRival = 0.1;
// A part that holds this share of the edge's cells is the outside.
constexpr double kOutside = 0.5;

/// Size of a connected part, in cells.
struct Part {
  std::size_t cells = 0;
  std::size_t edge_cells = 0;
};

std::vector<Part> parts_of(const Grid& grid, const std::vector<int>& labels) {
  std::vector<Part> parts;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const int label = labels[flat_index(grid, {column, row})];
      if (label < 0) continue;
      if (static_cast<std::size_t>(label) >= parts.size()) {
        parts.resize(static_cast<std::size_t>(label) + 1);
      }
      Part& part = parts[static_cast<std::size_t>(label)];
      ++part.cells;
      const bool edge =
          row == 0 || column == 0 || row == grid.height - 1 || column == grid.width - 1;
      part.edge_cells += edge ? 1U : 0U;
    }
  }
  return parts;
}

/// Label of the part at a point, or of the nearest one within `reach` [m]; -1 if there is none.
int part_near(const Grid& grid, const std::vector<int>& labels, const Eigen::Vector2d& p,
              double reach) {
  const CellIndex middle = cell_of(grid, p);
  const int around = static_cast<int>(std::ceil(reach / grid.resolution));
  int best = -1;
  double best_distance = reach + grid.resolution;
  for (int row = middle.row - around; row <= middle.row + around; ++row) {
    for (int column = middle.column - around; column <= middle.column + around; ++column) {
      if (!grid.contains(column, row)) continue;
      const int label = labels[flat_index(grid, {column, row})];
      const double distance = (center_of(grid, {column, row}) - p).norm();
      if (label < 0 || distance >= best_distance) continue;
      best = label;
      best_distance = distance;
    }
  }
  return best;
}

/// The largest part with or without cells at the edge; -1 if there is none.
int largest(const std::vector<Part>& parts, bool at_edge) {
  int best = -1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if ((parts[i].edge_cells > 0) != at_edge) continue;
    if (best < 0 || parts[i].cells > parts[static_cast<std::size_t>(best)].cells) {
      best = static_cast<int>(i);
    }
  }
  return best;
}

/// The free space in connected parts between which a disc cannot pass.
struct Partition {
  double reach = 0.0;  ///< [m] Radius of the disc plus half a cell.
  std::vector<int> labels;
  std::vector<Part> parts;

  [[nodiscard]] const Part& at(int part) const { return parts[static_cast<std::size_t>(part)]; }
};

Partition split_free_space(const Grid& grid, const std::vector<float>& distance, double radius) {
  Partition partition;
  partition.reach = radius + 0.5 * grid.resolution;
  partition.labels = component_labels(erode(grid, distance, radius));
  partition.parts = parts_of(grid, partition.labels);
  return partition;
}

/// The largest enclosed part if it is preferred to the largest part at the edge; -1 otherwise.
int rival(const Grid& grid, const Partition& partition) {
  const int enclosed = largest(partition.parts, false);
  const int open = largest(partition.parts, true);
  if (enclosed < 0 || open < 0) return enclosed;
  const auto inner = static_cast<double>(partition.at(enclosed).cells);
  if (inner * grid.resolution * grid.resolution < kSizeable) return -1;
  return inner >= kRival * static_cast<double>(partition.at(open).cells) ? enclosed : -1;
}

/// True if the largest part at the edge is the outside of the walls.
bool outside(const Grid& grid, const Partition& partition) {
  const int open = largest(partition.parts, true);
  const double edge = 2.0 * (grid.width + grid.height) - 4.0;
  return open >= 0 && static_cast<double>(partition.at(open).edge_cells) >= kOutside * edge;
}

/// The part to choose without a start; -1 if there is none.
int without_start(const Grid& grid, const Partition& partition) {
  const int enclosed = largest(partition.parts, false);
  const int open = largest(partition.parts, true);
  if (enclosed < 0 || open < 0) return std::max(enclosed, open);
  if (rival(grid, partition) >= 0) return enclosed;
  const double cell = grid.resolution * grid.resolution;
  if (static_cast<double>(partition.at(enclosed).cells) * cell < kRoom) return open;
  return outside(grid, partition) ? enclosed : open;
}

/// The grid without free cells that are not connected to the part, such as those behind walls.
Grid connected_cells(Grid grid, const std::vector<int>& labels, int part) {
  const std::vector<int> pieces = component_labels(grid);
  std::vector<bool> kept;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (labels[i] != part) continue;
    const auto piece = static_cast<std::size_t>(pieces[i]);
    if (piece >= kept.size()) kept.resize(piece + 1);
    kept[piece] = true;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto piece = static_cast<std::size_t>(std::max(pieces[i], 0));
    if (pieces[i] >= 0 && (piece >= kept.size() || !kept[piece])) grid.cells[i] = Cell::kUnknown;
  }
  return grid;
}

/// The grid with only those free cells that lie in a part or within `reach` [m] of it.
Grid around_part(const Grid& grid, const std::vector<int>& labels, int part, double reach) {
  Grid others = grid;
  for (std::size_t i = 0; i < others.cells.size(); ++i) {
    others.cells[i] = labels[i] == part ? Cell::kOccupied : Cell::kFree;
  }
  const std::vector<float> distance = distance_to_obstacle(others, GridEdge::kOpen);
  Grid result = grid;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    if (result.cells[i] == Cell::kFree && distance[i] > reach) result.cells[i] = Cell::kUnknown;
  }
  return connected_cells(std::move(result), labels, part);
}

/// A part, and the partition in which it was found.
struct ChosenPart {
  Partition partition;
  int part = -1;          ///< -1: there is none.
  bool by_start = false;  ///< It was chosen by the start.
};

ChosenPart choose_part(const Grid& grid, double radius,
                       const std::optional<Eigen::Vector2d>& start) {
  const std::vector<float> distance = distance_to_obstacle(grid, GridEdge::kOpen);
  ChosenPart chosen{split_free_space(grid, distance, radius), -1, false};
  Partition& partition = chosen.partition;
  if (start) {
    chosen.part = part_near(grid, partition.labels, *start, partition.reach + grid.resolution);
  }
  chosen.by_start = chosen.part >= 0;
  if (chosen.by_start) return chosen;
  chosen.part = without_start(grid, partition);
  // A house with gaps in its walls is connected to the outside, except for larger robots.
  for (const double larger : {1.5, 2.0}) {
    if (rival(grid, partition) >= 0 || chosen.part < 0 || !outside(grid, partition)) break;
    Partition coarse = split_free_space(grid, distance, larger * radius);
    const int inner = rival(grid, coarse);
    if (inner < 0) continue;
    partition = std::move(coarse);
    chosen.part = inner;
  }
  return chosen;
}

/// Number of cells of the largest part that was not chosen.
std::size_t largest_other(const ChosenPart& chosen) {
  const std::vector<Part>& parts = chosen.partition.parts;
  std::size_t other = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (static_cast<int>(i) != chosen.part) other = std::max(other, parts[i].cells);
  }
  return other;
}

FreeChoice::Reason reason_of(const FreeChoice& choice, bool by_start) {
  using Reason = FreeChoice::Reason;
  if (choice.other_area < std::max(kSizeable, kRival * choice.area)) return Reason::kOnly;
  if (by_start) return Reason::kStart;
  return choice.at_edge ? Reason::kLargest : Reason::kEnclosed;
}

}  // namespace

FreeChoice choose_free(const Grid& grid, double radius,
                       const std::optional<Eigen::Vector2d>& start) {
  FreeChoice choice;
  choice.grid = grid;
  const ChosenPart chosen = choose_part(grid, radius, start);
  if (chosen.part < 0) return choice;
  const Partition& partition = chosen.partition;
  const std::size_t other = largest_other(chosen);
  const Part& taken = partition.at(chosen.part);
  const double cell = grid.resolution * grid.resolution;
  choice.area = static_cast<double>(taken.cells) * cell;
  choice.other_area = static_cast<double>(other) * cell;
  choice.at_edge = taken.edge_cells > 0;
  choice.reason = reason_of(choice, chosen.by_start);
  if (other >= taken.cells) {
    choice.grid =
        around_part(grid, partition.labels, chosen.part, partition.reach + 1.5 * grid.resolution);
  }
  return choice;
}

std::optional<std::string> describe(const FreeChoice& choice) {
  using Reason = FreeChoice::Reason;
  const auto sentence = [&](const char* why) {
    return fmt::format(
        "free space: the map has several parts; the one of {:.0f} m2 is used, {}; the largest "
        "other one has {:.0f} m2; set `start` to choose a part",
        choice.area, why, choice.other_area);
  };
  switch (choice.reason) {
    case Reason::kStart:
      return sentence("which contains the start");
    case Reason::kEnclosed:
      return sentence("the largest that does not touch the map's edge");
    case Reason::kLargest:
      return sentence("the largest, though it touches the map's edge");
    default:
      return std::nullopt;
  }
}

}  // namespace castaway::sim
