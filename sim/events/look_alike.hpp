/// Finds poses whose scans are nearly the same as the one from a given pose.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/casting/ray_scene.hpp"
#include "sim/common/geometry.hpp"
#include "sim/map/free_space.hpp"
#include "sim/sensor/lidar_config.hpp"

namespace castaway::sim {

/// Parameters of the search.
struct LookAlikeConfig {
  double step = 0.25;  ///< [m] Between the places of the search.
  int beams = 72;      ///< Of the view from a place all around; also the number of headings tried.
  int fine_beams = 180;      ///< Of the views that the best places are refined with.
  double cap = 1.0;          ///< [m] A larger difference of two ranges counts as this much.
  std::size_t refined = 24;  ///< Number of places that are refined.
};

/// A pose whose scan resembles that of another pose.
struct Twin {
  Pose2 T_map_base;
  double unlikeness = 0.0;  ///< [m] Mean difference of the ranges, each capped at `cap`.
};

/// Holds views from places all over a world, to compare them with the view from a pose. People are
/// not part of the views. Views are level: a tilted lidar counts as a level one at its position.
class LookAlikes {
 public:
  /// `scene` must outlive this. `free`: where base can be. Casts `beams` rays from every place.
  LookAlikes(const RayScene& scene, const FreeSpace& free, const LidarConfig& lidar,
             const LookAlikeConfig& config = {});

  /// Most similar pose at least `min_distance` [m] away; nothing if no place is that far away.
  [[nodiscard]] std::optional<Twin> most_alike(const Pose2& T_map_base, double min_distance) const;
  /// Difference of the views from two poses, as in `Twin`.
  [[nodiscard]] double unlikeness(const Pose2& a, const Pose2& b) const;

 private:
  using View = std::vector<float>;
  /// A query.
  struct Search {
    Pose2 from;
    double min_distance;  ///< [m]
  };
  /// A place of the search.
  struct Place {
    Eigen::Vector2d p_map_laser;
    /// [m] By direction in map, twice around: the view in every heading is a contiguous part.
    View view;
  };

  [[nodiscard]] Eigen::Vector2d p_map_laser(const Pose2& T_map_base) const;
  [[nodiscard]] Pose2 base_of(const Eigen::Vector2d& p_map_laser, double yaw) const;
  [[nodiscard]] View view(const Eigen::Vector2d& p_map_laser, double yaw, int beams) const;
  [[nodiscard]] std::vector<float> seen_share(int beams) const;
  [[nodiscard]] Twin best_heading(const Place& place, const View& wanted) const;
  [[nodiscard]] std::vector<Twin> best_places(const Search& search) const;
  [[nodiscard]] bool is_allowed(const Pose2& pose, const Search& search) const;
  [[nodiscard]] Twin best_step(const Twin& twin, const Search& search, double way,
                               double turn) const;
  [[nodiscard]] Twin refine(Twin twin, const Search& search) const;

  const RayScene* scene_;
  FreeSpace free_;
  LidarConfig lidar_;
  LookAlikeConfig config_;
  Eigen::Vector2d p_base_laser_;
  std::vector<float> coarse_mask_;  ///< 1 where the lidar has a beam, by direction in base.
  std::vector<float> fine_mask_;
  std::vector<Place> places_;
};

}  // namespace castaway::sim
