/// The cascade matcher of the paper (section IV-A): every cell of the coarsest level in every
/// orientation, then at each finer level only the cells within the candidates of the level above.
///
/// Orientations are pi/8 apart at all levels, which limits the method: at 5 m the end points of
/// neighbouring orientations are 2 m apart, so that the right place often has a low score. Where
/// the paper is silent: the sensor's sigma is widened to half a cell at coarse levels; the
/// threshold is the same at all levels; candidates within 0.5 m and one orientation of a better one
/// are dropped at the end. Nodes whose bound (`HitBounds`) is below the threshold are not
/// evaluated, which changes no result (`localization_bench`).
#pragma once

#include <functional>
#include <numbers>
#include <vector>

#include "localization/matching/cascade_matcher.hpp"
#include "localization/paper/hit_bounds.hpp"
#include "localization/paper/rays_at_yaw.hpp"

namespace castaway::localization {

/// Parameters of the cascade.
struct PaperCascadeConfig {
  int levels = 4;                            ///< Level 0 is the map; each level doubles the cells.
  int finest_level = 0;                      ///< Level at which the search ends.
  double yaw_step = std::numbers::pi / 8.0;  ///< [rad]
  double threshold = 0.5;                    ///< Least quality of a candidate at any level.
  double apart_m = 0.5;                      ///< [m] Least distance of two candidates returned.
  /// Largest number of candidates, the best ones, that go on to the next level.
  int max_per_level = 4000;
};

/// True if the cell of the coarsest level at this column and row is searched.
using CellFilter = std::function<bool(const GridFrame& frame, int column, int row)>;

/// Searches one map with the metric of eq. 9.
class PaperCascade {
 public:
  /// Searches the cells that pass `is_searched`, or all cells without it.
  PaperCascade(const PaperCascadeConfig& config, const RayLocalConfig& sensor,
               const OccupancyGrid& grid, const CellFilter& is_searched = {});

  /// Returns candidates on free cells with their quality, best first.
  [[nodiscard]] std::vector<Candidate> match(const ScanPoints& points) const;

 private:
  struct Level {
    OccupancyGrid grid;
    RayLocalModel model;
    HitBounds bounds;
  };
  /// A cell and an orientation.
  struct Node {
    Eigen::Vector2i cell;
    std::size_t yaw = 0;
    std::int64_t bound = 0;  ///< See `HitBounds`.
    double quality = -1.0;   ///< Negative until it is evaluated.
  };
  [[nodiscard]] bool is_possible(std::size_t level, const Eigen::Vector2i& cell) const;
  [[nodiscard]] std::vector<CellRun> searched_runs(const CellFilter& is_searched) const;
  [[nodiscard]] std::vector<RaysAtYaw> rays_by_yaw(const Level& level,
                                                   const ScanPoints& points) const;
  [[nodiscard]] std::vector<Node> likely_nodes(const std::vector<RaysAtYaw>& rays,
                                               std::size_t beams) const;
  [[nodiscard]] std::vector<Node> likely_children(const std::vector<Node>& nodes, std::size_t level,
                                                  const std::vector<RaysAtYaw>& rays,
                                                  std::size_t beams) const;
  [[nodiscard]] double least_of_strongest(std::vector<Node>& nodes,
                                          const std::vector<RaysAtYaw>& rays,
                                          std::size_t beams) const;
  [[nodiscard]] std::vector<Node> score_nodes(const Level& level, std::vector<Node> nodes,
                                              const std::vector<RaysAtYaw>& rays,
                                              std::size_t beams) const;
  [[nodiscard]] std::vector<Node> best_nodes(const ScanPoints& points) const;
  [[nodiscard]] double yaw_of(const Level& level, std::size_t yaw) const;
  [[nodiscard]] SE2 pose_of(const Level& level, const Node& node) const;

  PaperCascadeConfig config_;
  std::vector<Level> levels_;  ///< Finest first.
  int yaws_;
  std::vector<CellRun> runs_;  ///< Cells of the coarsest level that are searched.
};

}  // namespace castaway::localization
