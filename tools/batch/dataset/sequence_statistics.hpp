/// Statistics of one sequence of a data set, and its difficulty.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/outputs/records/scan_row.hpp"

namespace castaway::testbed {

inline constexpr double kRangeBin = 0.5;      ///< [m] Width of a bin of ranges.
inline constexpr int kRangeBins = 60;         ///< Covers up to 30 m; longer ranges are in the last
                                              ///< bin.
inline constexpr int kOccludedBins = 20;      ///< Bins of the share of occluded beams.
inline constexpr double kCoverageCell = 0.5;  ///< [m] Edge of a coverage cell.

/// Odometry error over the distance driven, relative to the true pose. It starts anew when the
/// robot is picked up or put down.
class OdometryDrift {
 public:
  void add(const OdometryFrame& frame);
  /// Call this when the robot was moved by something other than its wheels.
  void restart() { marks_.clear(); }

  /// [m] Mean position error after two metres of driving, per metre; nothing below two metres.
  [[nodiscard]] std::optional<double> per_metre() const;
  /// [rad] Mean yaw error after two metres of driving, per metre; nothing below two metres.
  [[nodiscard]] std::optional<double> yaw_per_metre() const;
  /// Pairs of whole metres driven since the start and the position error there [m].
  [[nodiscard]] const std::vector<std::pair<int, double>>& curve() const { return curve_; }

 private:
  /// Odometry and true pose where a whole metre is reached.
  struct Mark {
    SE2 T_odom_base;
    SE2 T_map_base;
  };

  void set_mark(const Mark& mark);

  std::vector<Mark> marks_;
  SE2 last_;
  double driven_ = 0.0;
  double error_sum_ = 0.0;
  double yaw_sum_ = 0.0;
  int windows_ = 0;
  std::vector<std::pair<int, double>> curve_;
};

/// Accumulates statistics while a run is played.
class SequenceStatistics {
 public:
  void add(const RunEvent& event);
  void add(const OdometryFrame& frame);
  /// `row` holds the labels of the scan; the localizers are in the order of `row.lost`.
  void add(const ScanRecord& record, const ScanRow& row);
  void end_at(Stamp end) { end_ = end; }

  /// All statistics in SI units: counts, `difficulty`, `statistics`.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  void add_beams(const ScanRecord& record, const ScanRow& row);

  Stamp end_{};
  std::int64_t scans_ = 0;
  std::int64_t beams_ = 0;
  int people_ = 0;
  int collisions_ = 0;
  int faults_ = 0;
  nlohmann::ordered_json kidnaps_ = nlohmann::ordered_json::array();
  std::array<std::int64_t, kRangeBins> ranges_{};
  std::array<std::int64_t, kBeamClasses> classes_{};
  std::array<std::int64_t, kOccludedBins> occluded_{};
  double occluded_sum_ = 0.0;
  double occluded_max_ = 0.0;
  double ambiguity_sum_ = 0.0;
  std::int64_t judged_ = 0;  ///< Scans that have an ambiguity score.
  std::map<std::string, std::int64_t> lost_;
  std::map<std::pair<int, int>, std::int64_t> coverage_;
  std::optional<SE2> last_;  ///< True pose; nothing directly after a kidnap.
  double driven_ = 0.0;
  OdometryDrift drift_;
  bool held_ = false;
};

/// Forwards a run to its statistics.
class StatisticsSink final : public RunSink {
 public:
  /// `statistics` must outlive the sink.
  StatisticsSink(SequenceStatistics& statistics, std::shared_ptr<const LabelContext> context)
      : statistics_(statistics), labeller_(std::move(context)) {}

  void on_event(const RunEvent& event) override {
    labeller_.add(event);
    statistics_.add(event);
  }
  void on_odometry(const OdometryFrame& frame) override { statistics_.add(frame); }
  void on_scan(const ScanRecord& record) override {
    statistics_.add(record, labeller_.row_of(record));
  }
  void finish(Stamp end, const RunTiming&) override { statistics_.end_at(end); }

 private:
  SequenceStatistics& statistics_;
  ScanLabeller labeller_;
};

}  // namespace castaway::testbed
