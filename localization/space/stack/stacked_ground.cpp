#include "localization/space/stack/stacked_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace castaway::localization {
namespace {

constexpr double kLevel = 0.02;
constexpr double kSteepnessStep = 0.06;  // Of steepness.
constexpr int kDirections = 16;

/// Steepness and direction in steps; (0, 0) for level ground.
std::pair<int, int> bin_of(const GroundSurface& surface) {
  const double x = surface.slope_x;
  const double y = surface.slope_y;
  const double steepness = std::hypot(x, y);
  if (!(steepness >= kLevel)) return {0, 0};
  const double turns = std::atan2(y, x) / (2.0 * std::numbers::pi);
  const auto direction = static_cast<int>(std::lround(kDirections * turns));
  return {1 + static_cast<int>((steepness - kLevel) / kSteepnessStep),
          (direction + kDirections) % kDirections};
}

/// Surfaces of one bin.
struct Bin {
  std::uint16_t number = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
};

}  // namespace

SlopeClasses sort_by_slope(const ElevationMap& ground) {
  std::map<std::pair<int, int>, Bin> bins{{{0, 0}, {}}};
  SlopeClasses classes;
  classes.of_surface.assign(ground.surfaces.size(), 0);
  for (std::size_t i = 0; i < ground.surfaces.size(); ++i) {
    const GroundSurface& surface = ground.surfaces[i];
    if (!surface.drivable) continue;
    const auto next = static_cast<std::uint16_t>(bins.size());
    Bin& bin = bins.try_emplace(bin_of(surface), Bin{next}).first->second;
    bin.sum += Eigen::Vector2f(surface.slope_x, surface.slope_y).cast<double>();
    bin.count += 1.0;
    classes.of_surface[i] = bin.number;
  }
  classes.slopes.assign(bins.size(), Eigen::Vector2d::Zero());
  for (const auto& [key, bin] : bins) {
    if (bin.number > 0) classes.slopes[bin.number] = bin.sum / bin.count;
  }
  return classes;
}

Eigen::Matrix3d orientation_on(const Eigen::Vector2d& slope, double yaw) {
  const Eigen::Vector2d heading(std::cos(yaw), std::sin(yaw));
  Eigen::Matrix3d R_grid_base;
  R_grid_base.col(0) = Eigen::Vector3d(heading.x(), heading.y(), slope.dot(heading)).normalized();
  R_grid_base.col(2) = Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  R_grid_base.col(1) = R_grid_base.col(2).cross(R_grid_base.col(0));
  return R_grid_base;
}

StackedGround::StackedGround(const Atlas& atlas, const StackFrame& stack)
    : atlas_(atlas), stack_(stack), classes_(sort_by_slope(atlas.ground())) {
  find_places();
}

/// Of several cells of the atlas in a cell, the one nearest to the centre counts.
void StackedGround::find_places() {
  const GridFrame& frame = atlas_.frame();
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      if (atlas_.is_own({column, row})) places_.push_back(place_of({column, row}));
    }
  }
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return std::tie(a.cell, a.off_centre, a.atlas_cell) <
           std::tie(b.cell, b.off_centre, b.atlas_cell);
  });
  const auto same_cell = [](const Place& a, const Place& b) { return a.cell == b.cell; };
  places_.erase(std::unique(places_.begin(), places_.end(), same_cell), places_.end());
}

/// Requires ground there.
StackedGround::Place StackedGround::place_of(const Eigen::Vector2i& atlas_cell) const {
  const GroundSurface& surface = *atlas_.surface_at(atlas_cell);
  const Eigen::Vector2i fine(atlas_cell.x(), atlas_cell.y() % atlas_.stride());
  const Eigen::Vector2i cell =
      stack_.stacked(fine / stack_.factor, stack_.plane_of(static_cast<double>(surface.z)));
  const Eigen::Vector2i within = fine - fine / stack_.factor * stack_.factor;
  const Eigen::Vector2i off = 2 * within.array() + 1 - stack_.factor;
  const auto index = static_cast<std::size_t>(&surface - atlas_.ground().surfaces.data());
  return {static_cast<std::uint32_t>(stack_.grid().index(cell)), classes_.of_surface[index],
          static_cast<std::uint32_t>(atlas_.frame().index(atlas_cell)),
          std::abs(off.x()) + std::abs(off.y())};
}

Eigen::Vector2i StackedGround::stack_cell(const Place& place) const {
  const int width = stack_.plane.width;
  const auto cell = static_cast<int>(place.cell);
  return {cell % width, cell / width};
}

std::vector<Eigen::Vector2i> StackedGround::cells_of_slope(std::uint16_t slope) const {
  std::vector<Eigen::Vector2i> cells;
  for (const Place& place : places_) {
    if (place.slope == slope) cells.push_back(stack_cell(place));
  }
  return cells;
}

std::optional<GroundCell> StackedGround::cell_of(const Eigen::Vector2i& atlas_cell) const {
  if (atlas_.surface_at(atlas_cell) == nullptr) return std::nullopt;
  const Place place = place_of(atlas_cell);
  return GroundCell{stack_cell(place), place.slope};
}

SE2 StackedGround::pose_at(const Eigen::Vector2i& cell, double yaw_grid) const {
  const auto number = static_cast<std::uint32_t>(stack_.grid().index(cell));
  const auto place =
      std::lower_bound(places_.begin(), places_.end(), number,
                       [](const Place& other, std::uint32_t value) { return other.cell < value; });
  const auto atlas_cell = static_cast<int>(place->atlas_cell);
  const GridFrame& frame = atlas_.frame();
  const Eigen::Vector2d p = frame.centre_of({atlas_cell % frame.width, atlas_cell / frame.width});
  return frame.T_map_grid * SE2{p.x(), p.y(), yaw_grid};
}

}  // namespace castaway::localization
