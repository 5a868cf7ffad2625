/// Evidence of a scan for a pose, on one scale for all places of a map: end points and rays
/// together.
#pragma once

#include "localization/sensor/endpoint_model.hpp"
#include "localization/sensor/ray_consistency.hpp"

namespace castaway::localization {

/// Parameters of the evidence.
struct EvidenceConfig {
  /// Sharp, since the place of a wall distinguishes the right pose from look-alikes. A short beam
  /// (a person) costs at most log(floor).
  EndpointConfig endpoint{0.05, 0.1, 10.0};
  RayConsistencyConfig rays;
  /// Likelihood of a beam through a mapped wall, relative to one on a wall.
  double through_wall = 0.02;
  /// Subtracted from the mean log-likelihood if base is not on a free cell.
  double off_free_penalty = 0.5;
  /// A beam counts as at most this many independent ones: a scan with few beams says little.
  double per_beam = 0.4;
  /// [nats] Log-likelihood of a scan at a right pose on a right map: end points scatter by the
  /// lidar's noise and the map's cells. Subtracted.
  double right_pose = -1.2;
  /// [rad] Standard deviation of the direction up, on a 3-D map.
  double tilt_sigma = 0.03;
  double most_tilt = 4.0;  ///< [nats] Upper limit of what a wrong direction costs.
  double minimum = -25.0;  ///< Lower limit: one bad scan must not outweigh a long confident track.
};

/// Log-likelihood of a scan and its quality.
struct Evidence {
  double log_likelihood = 0.0;  ///< About 0 at a right pose, `minimum` at worst.
  double quality = 0.0;  ///< In [0, 1]: mean likelihood of the beams; paper, eq. 9, at one pose.
};

/// Evaluates scans against one map, planar or 3-D; `grid` must outlive the model.
class EvidenceModel {
 public:
  EvidenceModel(const EvidenceConfig& config, const OccupancyGrid& grid,
                const DistanceField& distances);
  /// `volume` must outlive the model; poses are in its atlas.
  EvidenceModel(const EvidenceConfig& config, const Volume& volume);
  /// Evidence of a scan at a pose. Without beams: neutral, quality 0.
  [[nodiscard]] Evidence evaluate(const ScanPoints& points, const SE2& T_map_base) const;
  /// Returns the log-likelihood if it is above `least`; otherwise some value that is not above it,
  /// found with as few rays as possible.
  [[nodiscard]] double log_likelihood_above(double least, const ScanPoints& points,
                                            const SE2& T_map_base) const;
  /// Upper bound of the log-likelihood at a tenth of its cost: rays are not evaluated.
  [[nodiscard]] double bound(const ScanPoints& points, const SE2& T_map_base) const;

  /// The part of the evidence without rays.
  [[nodiscard]] const EndpointModel& endpoint() const { return endpoint_; }
  /// What rays may meet.
  [[nodiscard]] RayWorld world() const {
    return volume_ != nullptr ? RayWorld(volume_) : RayWorld(&*walls_);
  }

 private:
  /// Of each beam, without rays.
  [[nodiscard]] std::vector<double> log_likelihoods(const ScanPoints& points,
                                                    const SE2& T_map_base) const;
  /// Sum of what each beam adds to the quality.
  [[nodiscard]] double sum_of_likelihoods(const std::vector<double>& beams) const;
  [[nodiscard]] double share(std::size_t beams) const;
  [[nodiscard]] bool is_free(const SE2& T_map_base) const;
  [[nodiscard]] double scale_sum(double sum, const ScanPoints& points, const SE2& T_map_base) const;
  [[nodiscard]] double tilt_cost(const ScanPoints& points, const SE2& T_map_base) const;

  EvidenceConfig config_;
  const OccupancyGrid* grid_ = nullptr;  ///< Of a planar map.
  std::optional<WallClearance> walls_;   ///< Of a planar map.
  const Volume* volume_ = nullptr;       ///< A 3-D map.
  EndpointModel endpoint_;
  double through_wall_ = 0.0;  ///< [nats] Log-likelihood of a beam through a wall.
};

}  // namespace castaway::localization
