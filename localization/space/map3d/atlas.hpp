/// An atlas of the ground: floors that lie above each other, side by side in one plane.
///
/// A chart is a part of the ground with one surface in each cell. Poses in the plane of the atlas
/// are planar, and say by their position on which floor they are: filters and hypotheses of planar
/// poses serve for buildings, too.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/space/map3d/charts.hpp"
#include "localization/space/map3d/elevation_map.hpp"

namespace castaway::localization {

/// A pose with the surface that it is on.
struct GroundPose {
  SE2 T_map_base;
  const GroundSurface* surface = nullptr;  ///< Never null.
};

/// Built once, then only read. Every chart has the size of the whole ground; translations between
/// map and atlas do not turn.
class Atlas {
 public:
  /// Takes the drivable surfaces of a map. `margin` [m]: how far charts overlap over their edges.
  /// @throws std::invalid_argument for an invalid map, or one without drivable ground.
  Atlas(ElevationMap ground, double margin);

  /// The pose in map, whether there is ground or not.
  [[nodiscard]] SE2 in_map(const SE2& T_atlas_base) const;
  /// The pose in map; nothing where the atlas has no ground.
  [[nodiscard]] std::optional<GroundPose> to_map(const SE2& T_atlas_base) const;
  /// The pose in the atlas, on the drivable surface nearest to the height `z`; nothing if there is
  /// none in its cell.
  [[nodiscard]] std::optional<SE2> to_atlas(const SE2& T_map_base, double z) const;
  /// The translation from a pose's chart to the one that its surface belongs to; zero within the
  /// chart, and where there is no ground. [m]
  [[nodiscard]] Eigen::Vector2d to_own_chart(const SE2& T_atlas_base) const;

  /// The pose in the chart that its surface belongs to.
  [[nodiscard]] SE2 on_own_chart(const SE2& T_atlas_base) const {
    const Eigen::Vector2d shift = to_own_chart(T_atlas_base);
    return {T_atlas_base.x + shift.x(), T_atlas_base.y + shift.y(), T_atlas_base.yaw};
  }

  /// The plane of the atlas as a grid; T_map_grid is in the atlas.
  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  /// The surface of a cell of `frame`; null if it has none.
  [[nodiscard]] const GroundSurface* surface_at(const Eigen::Vector2i& cell) const;
  /// True if a cell of `frame` has a surface that belongs to its chart: each drivable surface does
  /// in exactly one cell.
  [[nodiscard]] bool is_own(const Eigen::Vector2i& cell) const;
  /// The cell that the surface of a cell belongs to; the cell itself if it has none.
  [[nodiscard]] Eigen::Vector2i own_cell(const Eigen::Vector2i& cell) const;
  [[nodiscard]] const ElevationMap& ground() const { return ground_; }
  /// `localization::grid_from_map` of the ground.
  [[nodiscard]] const PlaneTransform& grid_from_map() const { return T_grid_atlas_; }
  [[nodiscard]] int charts() const { return charts_; }
  /// Rows of `frame` from a row of a chart to the same one of the next.
  [[nodiscard]] int stride() const { return stride_; }

 private:
  void place(const Chart& chart, int first_row);
  [[nodiscard]] Eigen::Vector2d along_rows(int rows) const;
  [[nodiscard]] Eigen::Vector2i cell_of(const SE2& T_atlas_base) const;
  /// For a pose in a cell of `frame_`.
  [[nodiscard]] SE2 in_map(const SE2& T_atlas_base, const Eigen::Vector2i& cell) const;

  ElevationMap ground_;
  GridFrame frame_;
  PlaneTransform T_grid_atlas_{SE2{}};  ///< The same as from map.
  int charts_ = 0;
  int stride_ = 0;
  std::vector<std::int32_t> surfaces_;  ///< By cell of `frame_`; -1: none.
  std::vector<std::uint32_t>
      own_cells_;  ///< Of each surface, in `frame_`; none: the largest number.
};

}  // namespace castaway::localization
