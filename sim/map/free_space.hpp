/// Where a round robot can stand.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/map/grid.hpp"
#include "sim/map/grid_tools.hpp"

namespace castaway::sim {

struct LevelPlane;

/// A disc-shaped obstacle.
struct RoundObstacle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m] In map.
  double radius = 0.0;                               ///< [m]
};

/// The largest connected part of a grid's free space in which a disc can move. Copies share what
/// they hold.
class FreeSpace {
 public:
  /// `radius` [m]: of the disc. Unknown cells and everything outside count as obstacles.
  FreeSpace(const Grid& grid, double radius);
  /// The part at a point, or else the largest one.
  static FreeSpace around(const Grid& grid, double radius, const Eigen::Vector2d& p_map);
  /// All parts, whether or not a disc can get from one to another.
  static FreeSpace whole(const Grid& grid, double radius);

  /// The largest part of the ground of several floors, in frame plane: what is connected across
  /// floors, and belongs to its chart.
  static FreeSpace on_levels(std::shared_ptr<const LevelPlane> plane, double radius);

  /// Returns the same space with disc-shaped obstacles added.
  [[nodiscard]] FreeSpace with_discs(std::span<const RoundObstacle> discs) const;

  /// True if a disc centred on `p_map` is free and can reach the rest of the free space; on levels
  /// also where the ground belongs to another chart.
  [[nodiscard]] bool contains(const Eigen::Vector2d& p_map) const;
  /// True if `contains` holds along a straight line.
  [[nodiscard]] bool contains_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// The free cell nearest to a point; nothing if there is none. Linear in the number of cells if
  /// the point itself is not free.
  [[nodiscard]] std::optional<CellIndex> nearest_free(const Eigen::Vector2d& p_map) const;
  /// A pose drawn uniformly from the free cells at least `min_distance` [m] away from `from`;
  /// nothing if there is none.
  [[nodiscard]] std::optional<Pose2> sample(Rng& rng, const Eigen::Vector2d& from,
                                            double min_distance) const;
  /// A pose drawn uniformly; nothing if no cell is free.
  [[nodiscard]] std::optional<Pose2> sample(Rng& rng) const;

  /// Its free cells are where the centre of the disc can be.
  [[nodiscard]] const Grid& grid() const { return parts_->grid; }
  /// Distance from each cell to the nearest obstacle. [m]
  [[nodiscard]] const std::vector<float>& clearance() const { return parts_->clearance; }
  /// Distance at a point in map; 0 outside of the grid. [m]
  [[nodiscard]] double clearance_at(const Eigen::Vector2d& p_map) const;
  [[nodiscard]] double radius() const { return radius_; }
  /// The floors that it is on; null for a planar one.
  [[nodiscard]] const LevelPlane* levels() const { return levels_.get(); }

 private:
  struct Parts {
    std::vector<float> clearance;
    Grid grid;
    std::vector<std::size_t> free_in_row;
  };

  FreeSpace(double radius, std::vector<float> clearance, Grid grid);
  /// The free cell at a point, in its own chart; nothing if it is not free.
  [[nodiscard]] std::optional<CellIndex> free_cell(const Eigen::Vector2d& p_map) const;
  /// A free cell at least `reach` [m] away from a point.
  [[nodiscard]] std::optional<CellIndex> sample_cell(Rng& rng, const Eigen::Vector2d& from,
                                                     double reach) const;

  double radius_;
  std::shared_ptr<const Parts> parts_;
  std::shared_ptr<const LevelPlane> levels_{};
};

}  // namespace castaway::sim
