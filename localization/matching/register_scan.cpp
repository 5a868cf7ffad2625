#include "localization/matching/register_scan.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

namespace castaway::localization {
namespace {

constexpr int kMostSteps = 20;
constexpr double kMostDamping = 1e4;
constexpr double kLongest = 0.3;     // [m] or [rad] Of a step.
constexpr double kConverged = 2e-4;  // [m] or [rad]
constexpr double kLeastInformation = 1e-6;

/// A pose with the derivatives of its score.
struct Stage {
  Registration at;
  double score = 0.0;
  Eigen::Vector3d gradient;
  Eigen::Matrix3d information;
};

Stage evaluate(const NdtModel& model, const NdtScan& scan, const SE2& pose,
               const std::optional<PosePrior>& prior) {
  const NdtFit fit = model.fit(scan, pose);
  Stage stage{{pose, fit}, fit.log_likelihood, fit.gradient, fit.information};
  if (!prior) return stage;
  stage.score += log_prior(*prior, pose);
  stage.gradient -= prior->information * difference(pose, prior->mean);
  stage.information += prior->information;
  return stage;
}

Eigen::Vector3d damped_step(const Stage& stage, double damping) {
  Eigen::Matrix3d H = stage.information;
  H.diagonal() += damping * H.diagonal();
  H.diagonal().array() += kLeastInformation;
  const Eigen::Vector3d step = H.ldlt().solve(stage.gradient);
  const double longest = step.cwiseAbs().maxCoeff();
  return longest > kLongest ? (step * (kLongest / longest)).eval() : step;
}

}  // namespace

Registration register_scan(const NdtModel& model, const NdtScan& scan, const SE2& start,
                           const std::optional<PosePrior>& prior) {
  Stage best = evaluate(model, scan, start, prior);
  double damping = 1e-3;
  for (int i = 0; i < kMostSteps && damping < kMostDamping; ++i) {
    const Eigen::Vector3d step = damped_step(best, damping);
    if (step.cwiseAbs().maxCoeff() < kConverged) break;
    const Stage next = evaluate(model, scan, offset(best.at.T_map_base, step), prior);
    if (!(next.score > best.score)) {
      damping = std::max(10.0 * damping, 1e-2);
      continue;
    }
    best = next;
    damping *= 0.1;
  }
  return best.at;
}

NdtScan NdtRegistration::scan_of(const ScanPoints& points) const {
  return matching == NdtMatching::kPoints ? scan_of_points(points, model.is_planar())
                                          : scan_of_distributions(points, cell, model.is_planar());
}

}  // namespace castaway::localization
