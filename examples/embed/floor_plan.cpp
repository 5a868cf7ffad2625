#include "floor_plan.hpp"

#include <array>
#include <cmath>
#include <string_view>

using castaway::CellState;
using castaway::OccupancyGrid;

namespace {

constexpr double kSquare = 0.5;  // [m] Edge of a character.
constexpr int kCells = 10;       // Along it.
constexpr std::array<std::string_view, 16> kPlan = {
    "########################",  //
    "#........#.............#",  //
    "#........#.............#",  //
    "#....#...#....##.......#",  //
    "#........#....##.......#",  //
    "#......................#",  //
    "#......................#",  //
    "####..####.............#",  //
    "#........###########..##",  //
    "#..................#...#",  //
    "#..................#...#",  //
    "#...##.............#...#",  //
    "#...##.................#",  //
    "#.............#........#",  //
    "#.............#....#...#",  //
    "########################",
};

}  // namespace

OccupancyGrid floor_plan() {
  OccupancyGrid plan;
  plan.frame.width = kCells * static_cast<int>(kPlan.front().size());
  plan.frame.height = kCells * static_cast<int>(kPlan.size());
  plan.frame.resolution = kSquare / kCells;
  for (int row = 0; row < plan.frame.height; ++row) {
    for (int column = 0; column < plan.frame.width; ++column) {
      const std::string_view line =
          kPlan[kPlan.size() - 1 - static_cast<std::size_t>(row / kCells)];
      const bool wall = line[static_cast<std::size_t>(column / kCells)] == '#';
      plan.cells.push_back(wall ? CellState::kOccupied : CellState::kFree);
    }
  }
  return plan;
}

double distance_to_wall(const OccupancyGrid& plan, const Eigen::Vector2d& p_map, double direction,
                        double longest) {
  constexpr double kStep = 0.01;  // [m]
  const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
  double distance = 0.0;
  while (distance < longest && plan.at(p_map + distance * along) == CellState::kFree) {
    distance += kStep;
  }
  return distance;
}
