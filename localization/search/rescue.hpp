/// Rescue: a local search around an output that suddenly fits badly (after wheel slip, or a long
/// time without scans), and on the way of a long step, where time stamps may jitter.
#pragma once

#include <optional>

#include "localization/search/create.hpp"

namespace castaway::localization {

/// Conditions and range of a rescue.
struct RescueConfig {
  /// [nats] The surroundings are searched if the scan at the output is less likely than usual by
  /// more than this, divided by the periods since the scan before: sparse scans leave time for it,
  /// and jitter of their stamps moves a pose farther.
  double drop = 6.0;
  /// After so many periods without a scan, the surroundings are searched even if the scan fits as
  /// usual, which may have been learned beside the right pose.
  double sparse_periods = 8.0;
  double radius = 1.1;      ///< [m] Half edge of the square that is searched.
  double yaw_radius = 0.6;  ///< [rad]
  int candidates = 10;      ///< Maximum number of candidates that are refined.
  /// [nats] Candidates where the scan fits worse than at the output by more than this before
  /// refinement are not refined.
  double refined_behind = 3.0;
  double gain = 3.0;  ///< [nats] Minimum improvement by the place found.
  /// [nats] A place at the edge of the search starts with the output's weight minus this.
  double cost = 14.0;
  double cost_near = 7.0;  ///< [nats] The same next to the output; short slips are likelier.
  /// [nats] The same for a place on the way of the last step, where jitter of the time stamps moves
  /// a pose, if the output fits worse than usual by more than `drop`.
  double cost_on_way = 3.0;
  double cost_on_way_unnoticed = 7.0;  ///< [nats] The same if it does not.
  /// [m] or [rad] The way of a longer step is searched where the output fits worse than usual.
  double long_step = 0.2;
  double spacing = 0.1;      ///< [m] or [rad] Between the poses searched on the way.
  double beside_way = 0.25;  ///< [m] Largest distance from that way, without the step's share.
};

/// The motion since the previous scan.
struct LastStep {
  SE2 u;                 ///< Odometry's step of base.
  double periods = 1.0;  ///< As in `ScanTurn`.
};

/// True if `T_map_base` lies on the way of a step that passes the pose `centre`: at most twice the
/// step before or behind it, at most `beside` [m] and 0.3 times the step away from that line, and
/// at most twice the step's turn (and 0.1 rad) off.
bool is_on_way(const SE2& centre, const SE2& step, double beside, const SE2& T_map_base);

/// The pose on the way of a step that passes the pose `centre` at which the end points fit best;
/// nothing if none fits better than `centre`. Poses are `spacing` [m] or [rad] apart, or more if
/// the step is very long.
std::optional<SE2> best_on_way(const EndpointModel& model, const ScanPoints& points,
                               const SE2& centre, const SE2& step, double spacing);

/// Searches around outputs. The matcher must outlive it.
class Rescue {
 public:
  Rescue(const RescueConfig& config, const PlaceMatcher& matcher)
      : config_(config), matcher_(matcher) {}

  /// Returns a nearby place where the scan fits better than at the output; nothing if the output
  /// fits nearly perfectly, or about as well as `usual` [nats] unless scans are sparse, or if no
  /// better place is found. The place starts with the output's evidence minus the cost of the slip,
  /// so that one scan in a crowd does not move the output away. A slip is the more likely the
  /// longer the step took.
  [[nodiscard]] std::optional<WeighedPlace> find(const CreateContext& context,
                                                 const Hypothesis& output, double usual,
                                                 const ScanPoints& points,
                                                 const LastStep& step) const;
  /// True if a place is so near that a rescue could have moved the output there.
  [[nodiscard]] bool reaches(const SE2& output, const SE2& place) const;

 private:
  [[nodiscard]] std::vector<Candidate> candidates(const CreateContext& context, const SE2& centre,
                                                  double below_usual, const ScanPoints& points,
                                                  const LastStep& step) const;
  /// The places where the candidates converge, best first; `now` is the scan's log-likelihood at
  /// the output.
  [[nodiscard]] std::vector<WeighedPlace> refine(const CreateContext& context,
                                                 std::vector<Candidate> candidates, double now,
                                                 const ScanPoints& points) const;
  [[nodiscard]] double cost_of(const SE2& centre, const SE2& place, double below_usual,
                               const LastStep& step) const;

  RescueConfig config_;
  const PlaceMatcher& matcher_;
};

}  // namespace castaway::localization
