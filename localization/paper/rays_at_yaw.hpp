/// A scan in whole cells at one yaw: what a search over the centres of cells shares between them.
///
/// Seen from the centres of any two cells, all points of a ray lie in the same cells relative to
/// base, unless rounding errors carry a point over a border.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/matching/search_space.hpp"
#include "localization/paper/ray_local_model.hpp"

namespace castaway::localization {

/// Evaluates one scan at one yaw against one map. Model and scan must outlive it.
class RaysAtYaw {
 public:
  /// `yaw_map`: yaw of base in map. [rad]
  RaysAtYaw(const RayLocalModel& model, const ScanPoints& points, double yaw_map);

  /// Cells of the end points relative to that of base. A point within rounding errors of a border
  /// counts in the cells on both sides. Points are left out that lie far off the map from all of
  /// its cells.
  [[nodiscard]] const std::vector<CellOffset>& ends() const { return ends_; }
  /// Exactly the hits of `RayLocalModel::evaluate` for base at the centre of a cell.
  [[nodiscard]] double hits(const Eigen::Vector2i& cell) const;

 private:
  struct Ray;
  void add_ends(const Ray& ray);
  void add_probes(const Ray& ray);
  [[nodiscard]] std::size_t error_cells(std::size_t beam, const Eigen::Vector2i& cell) const;

  const RayLocalModel* model_;
  const ScanPoints* points_;
  double yaw_map_;
  std::vector<CellOffset> ends_;
  /// For each beam, the cells of its probes: the end point, then one ahead and one behind for every
  /// number of cells.
  std::vector<CellOffset> probes_;
  std::vector<std::uint8_t> certain_;  ///< For each beam: no probe is close to a border.
};

}  // namespace castaway::localization
