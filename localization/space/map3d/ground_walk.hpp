/// Walks over connected surfaces of an elevation map.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "localization/space/map3d/elevation_map.hpp"

namespace castaway::localization {

/// A surface and its cell.
struct SurfaceAt {
  Eigen::Vector2i cell = Eigen::Vector2i::Zero();
  std::size_t index = 0;  ///< Into `ElevationMap::surfaces`.
};

/// Visits each surface at most once, however many walks begin. The map must outlive it.
class GroundWalk {
 public:
  /// `step` [m]: largest difference in height of neighbouring cells that are connected.
  GroundWalk(const ElevationMap& map, float step)
      : map_(map), step_(step), seen_(map.surfaces.size(), false) {}

  /// Calls `visit(index)` for a surface and all that are connected with it (over the edges of
  /// cells) and for which `enters(surface)` is true. Returns how many there are.
  template <typename Enters, typename Visit>
  std::size_t from(const SurfaceAt& start, const Enters& enters, const Visit& visit) {
    std::size_t count = 0;
    open(start, enters);
    while (!open_.empty()) {
      const SurfaceAt at = open_.back();
      open_.pop_back();
      visit(at.index);
      ++count;
      for (const Eigen::Vector2i& step : kSteps) open_neighbours(at, step, enters);
    }
    return count;
  }

 private:
  static inline const std::array<Eigen::Vector2i, 4> kSteps{
      Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0), Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)};

  template <typename Enters>
  void open(const SurfaceAt& at, const Enters& enters) {
    if (seen_[at.index] || !enters(map_.surfaces[at.index])) return;
    seen_[at.index] = true;
    open_.push_back(at);
  }
  template <typename Enters>
  void open_neighbours(const SurfaceAt& from, const Eigen::Vector2i& step, const Enters& enters) {
    const Eigen::Vector2i cell = from.cell + step;
    if (!map_.frame.contains(cell)) return;
    const std::size_t i = map_.frame.index(cell);
    for (std::size_t index = map_.first[i]; index < map_.first[i + 1]; ++index) {
      const float rise = map_.surfaces[index].z - map_.surfaces[from.index].z;
      if (std::abs(rise) <= step_) open({cell, index}, enters);
    }
  }

  const ElevationMap& map_;
  float step_;
  std::vector<bool> seen_;
  std::vector<SurfaceAt> open_;
};

/// Calls `body(SurfaceAt)` for all surfaces of a map, cell by cell.
template <typename Body>
void for_each_surface(const ElevationMap& map, const Body& body) {
  for (int y = 0; y < map.frame.height; ++y) {
    for (int x = 0; x < map.frame.width; ++x) {
      const std::size_t cell = map.frame.index({x, y});
      for (std::size_t i = map.first[cell]; i < map.first[cell + 1]; ++i)
        body(SurfaceAt{{x, y}, i});
    }
  }
}

}  // namespace castaway::localization
