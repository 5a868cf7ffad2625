#include "localization/matching/pose_climber.hpp"

namespace castaway::localization {

SE2 PoseClimber::climb(const ScanPoints& points, const SE2& start,
                       const std::optional<PosePrior>& prior, const RefineConfig& config) const {
  if (ndt != nullptr) return ndt->register_points(points, start, prior).T_map_base;
  return refine_pose(model, points, start, prior, config);
}

PoseClimber::Summit PoseClimber::summit(const ScanPoints& points, const SE2& start,
                                        const PosePrior& prior, const RefineConfig& config) const {
  if (ndt != nullptr) {
    const Registration there = ndt->register_points(points, start, prior);
    return {there.T_map_base, there.fit.log_likelihood, there.fit.information};
  }
  const SE2 pose = refine_pose(model, points, start, prior, config);
  return {pose, model.log_likelihood(points, pose), scan_information(model, points, pose)};
}

double PoseClimber::log_likelihood(const ScanPoints& points, const SE2& T_map_base) const {
  return ndt != nullptr ? ndt->fit(points, T_map_base).log_likelihood
                        : model.log_likelihood(points, T_map_base);
}

Eigen::Matrix3d PoseClimber::information(const ScanPoints& points, const SE2& T_map_base) const {
  return ndt != nullptr ? ndt->fit(points, T_map_base).information
                        : scan_information(model, points, T_map_base);
}

}  // namespace castaway::localization
