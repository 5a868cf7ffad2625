/// The belief of MH-AMCL: all populations with their posterior, and the state of the output.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/hypotheses/lost_and_found.hpp"
#include "localization/hypotheses/populations.hpp"
#include "localization/hypotheses/posterior.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/mh_amcl/mh_amcl_models.hpp"

namespace castaway::localization {

/// Everything that scans and odometry change, except the search for further places.
struct Belief {
  /// Starts at an unknown pose. The models must outlive it.
  Belief(const MhAmclModels& mh_amcl_models, std::uint64_t seed);

  /// Restarts: with one population at `start`, or without populations at an unknown pose.
  void start(const std::optional<PoseWithCovariance>& start);
  /// Forgets all past motion, because odometry is not continuous with it any more. The populations
  /// keep their poses.
  void forget_motion();
  /// Adds a population at every place, with the covariance given by the scan.
  void add(const std::vector<WeighedPlace>& places, const ScanPoints& points);
  /// Selects the output and updates the alarm. Returns true if the output was confident before and
  /// is not any more.
  bool select();
  /// Learns the usual likelihood from the newest scan, if the output is confident.
  void learn();

  [[nodiscard]] bool is_confident() const {
    return populations.probability >= models.config.match.confident;
  }
  /// Probability that the robot is at a pose: of all populations that are as near as `same`.
  [[nodiscard]] double probability_at(const SE2& T_map_base) const;
  /// Posterior probabilities of the populations.
  [[nodiscard]] std::vector<double> shares() const { return posterior.shares(populations.all); }

  const MhAmclModels& models;
  Spawner spawner;
  Populations populations;
  Posterior posterior;
  LostAndFound lost_and_found;
};

}  // namespace castaway::localization
