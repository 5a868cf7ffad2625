/// Absolute pose error as `evo_ape tum truth.tum estimate.tum` computes it.
///
/// M. Grupp, evo, https://github.com/MichaelGrupp/evo; J. Sturm et al., "A Benchmark for the
/// Evaluation of RGB-D SLAM Systems", IROS 2012. With evo's defaults: poses are matched by time,
/// nothing is aligned or scaled, and of each pair the translation part counts,
///   e_i = |p_estimate,i - p_truth,i|.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tools/base/formats/tum.hpp"

namespace castaway::testbed {

/// evo's figures of the errors e_i, in metres.
struct Ape {
  std::size_t pairs = 0;
  double max = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double min = 0.0;
  double rmse = 0.0;  ///< sqrt(sum e_i^2 / n)
  double std = 0.0;   ///< sqrt(sum (e_i - mean)^2 / n)
};

/// Matches poses by time. For every pose of the shorter trajectory (of `b` if the lengths are
/// equal), finds the pose of the other that is nearest in time (the earlier one of a tie), if it is
/// within `max_apart`. Returns pairs of indices into `a` and `b`. Both trajectories must be sorted
/// by time.
std::vector<std::pair<std::size_t, std::size_t>> matched_by_time(
    const std::vector<StampedPose>& a, const std::vector<StampedPose>& b,
    std::chrono::nanoseconds max_apart = std::chrono::milliseconds(10));

/// Returns nothing if no pose has a match.
std::optional<Ape> absolute_pose_error(const std::vector<StampedPose>& truth,
                                       const std::vector<StampedPose>& estimate);

}  // namespace castaway::testbed
