/// MH-AMCL: several populations of particles, each a hypothesis about where the robot is.
///
/// A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable Multi-Hypothesis
/// Monte Carlo Localization for Mobile Robots", 2022: predict, correct and reseed run at rates of
/// their own; populations are created where a cascade matcher finds the scan, merged, destroyed,
/// and one is selected. Mode `paper` does that to the letter; mode `published` is the same with the
/// differences of the code that the authors published. Mode `improved` keeps the structure and
/// differs in the parts: winners are refined below the grid, places are weighed by rays as well
/// as end points, and a posterior over all places and "somewhere else" replaces the fixed gates of
/// quality.
#pragma once

#include "localization/hypotheses/correct_by_rays.hpp"
#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/hypothesis.hpp"
#include "localization/hypotheses/map_search.hpp"
#include "localization/localizer.hpp"
#include "localization/mh_amcl_config.hpp"
#include "localization/sensor/lidar_panorama.hpp"
#include "localization/stage_timer.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: same calls, same seed, same results.
class MhAmcl final : public Localizer {
 public:
  /// Throws std::invalid_argument for a map or settings that make no sense. Starts at an unknown
  /// place.
  MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  void restart_motion();
  void predict(const SE2& T_odom_base);
  [[nodiscard]] bool due(Stamp now, Stamp last, double rate_hz) const;
  void take_scan(const ScanPoints& points, Stamp now, const SE2& T_odom_base);
  void correct_all(const ScanPoints& points, const SE2& T_odom_base);
  void merge_all();
  void destroy_all();
  void reseed_all();
  void correct(Hypothesis& hypothesis, const ScanPoints& points);
  [[nodiscard]] CreateContext create_context() const;
  void rescue(const ScanPoints& points);
  void weigh(const ScanPoints& points, const SE2& T_odom_base);
  [[nodiscard]] bool hopeless() const;
  void note_jump();
  [[nodiscard]] bool proven() const;
  [[nodiscard]] bool match_due(Stamp now, const SE2& T_odom_base) const;
  void create(Stamp now, const SE2& T_odom_base);
  void begin_search(const ScanPoints& points, const SE2& T_odom_base);
  bool end_search(const ScanPoints& points, const SE2& T_odom_base);
  bool spawn_places(std::vector<WeighedPlace> places, const ScanPoints& points);
  void spawn(const PoseMoments& belief, double log_weight, const Evidence& evidence);
  void reseed(Hypothesis& hypothesis, const std::optional<PoseGaussian>& winner);
  void choose();
  void prepare_match(const LaserScan& scan, Stamp now);
  void correct_all_by_rays(const ScanPoints& points);
  void choose_by_quality();
  void choose_after_a_while();
  bool spawn_by_quality(const ScanPoints& points);
  [[nodiscard]] Hypothesis* selected();
  void publish(Stamp stamp);

  MhAmclConfig config_;
  std::uint64_t seed_;
  OccupancyGrid map_;
  DistanceField distances_;
  EndpointModel tracking_;
  EndpointModel endpoint_;
  EvidenceModel evidence_;
  CascadeMatcher matcher_;
  /// The paper's own parts; nothing in mode `improved`.
  struct PaperParts {
    RayLocalModel model;
    PaperCascade cascade;
    ScanPoints unmounted;  ///< The newest scan as if the lidar stood at base; empty unless asked.
  };
  [[nodiscard]] PaperParts paper_parts() const;
  std::optional<PaperParts> paper_;
  StageTimer timer_;

  Intake intake_;
  LidarPanorama panorama_;
  std::vector<Hypothesis> hypotheses_;
  Unlisted unlisted_;
  ScanHistory history_;
  std::optional<Estimate> estimate_;
  int next_id_ = 0;
  int selected_id_ = -1;
  double probability_ = 0.0;      ///< Share of the output.
  bool was_found_ = false;        ///< Since it was initialised.
  double kidnap_hint_ = 0.0;      ///< The highest kidnap cue, fading with the way.
  std::optional<SE2> jumped_at_;  ///< Odometry at a jump of the output that no kidnap explains.
  bool found_ = false;            ///< Mode `improved`: the output is not called lost.

  std::optional<SE2> predicted_at_;  ///< Odometry up to which particles are moved.
  Stamp last_predict_{};
  std::optional<Stamp> last_correct_;
  Stamp last_reseed_{};
  std::optional<Stamp> last_match_;
  std::optional<Stamp> better_since_;  ///< Mode `paper`: another population is better since then.
  SE2 matched_at_;                     ///< Odometry at the last match.
  int rescued_id_ = -1;                ///< The newest population that a rescue listed.
  int searches_ = 0;                   ///< Since the last alarm.
  std::optional<MapSearch> search_;    ///< Mode `improved`: the search that is going on.
  bool deeper_ = false;                ///< The last search found nothing that fits well.
  double pause_s_ = 0.0;               ///< Pause after the last match.
};

}  // namespace castaway::localization
