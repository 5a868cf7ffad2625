#include "tools/twin/alignment/aligned_log.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/build/build_localizers.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"
#include "tools/twin/alignment/expected_scan.hpp"
#include "tools/twin/alignment/scan_aligner.hpp"

namespace castaway::testbed {
namespace {

using localization::TransformBuffer;

/// A scan before its alignment.
struct RawScan {
  LaserScan scan;
  std::optional<SE2> T_map_base;  ///< Where to begin.
  bool breaks = false;
};

/// Accumulates corrected odometry.
class CorrectedPath {
 public:
  explicit CorrectedPath(const DriveErrors& errors) : errors_(errors) {}

  void add(const Odometry& odometry, TransformBuffer& T_path_base) {
    constexpr double kAnyTrack = 0.3;
    if (before_) {
      const SE2 u = before_->inverse() * odometry.T_odom_base;
      T_path_base_ = T_path_base_ * correct_base_motion({step_of(u, kAnyTrack)}, errors_);
    }
    before_ = odometry.T_odom_base;
    before_stamp_ = odometry.stamp;
    T_path_base.add(odometry.stamp, T_path_base_);
  }
  /// True if no robot drives so fast: odometry was reset.
  [[nodiscard]] bool jumps_to(const Odometry& odometry) const {
    constexpr double kFastest = 10.0;  // [m/s]
    constexpr double kSlack = 0.5;     // [m]
    if (!before_) return false;
    const double way = localization::distance(*before_, odometry.T_odom_base);
    return way > kSlack + kFastest * std::max(seconds(odometry.stamp - before_stamp_), 0.0);
  }

 private:
  DriveErrors errors_;
  std::optional<SE2> before_;
  Stamp before_stamp_{};
  SE2 T_path_base_;
};

/// Reads the scans of the first lidar and the odometry.
std::vector<RawScan> take_scans(const RecordedPlace& place, const ScanCorrection& correction,
                                AlignedLog& log) {
  std::vector<RawScan> scans;
  std::vector<double> periods;
  std::optional<Stamp> before;
  bool breaks = false;
  CorrectedPath path(correction.drive);
  for (const Frame& frame : place.frames) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      const Stamp now = odometry->odometry.stamp;
      if (before && now > *before) periods.push_back(seconds(now - *before));
      before = now;
      breaks = breaks || path.jumps_to(odometry->odometry);
      if (log.T_odom_base.add(now, odometry->odometry.T_odom_base)) {
        path.add(odometry->odometry, log.T_path_base);
      }
    } else if (const auto* event = std::get_if<RunEvent>(&frame.data)) {
      breaks = breaks || event->is<KidnapEvent>();
    } else if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      if (!scans.empty() && scan->scan.lidar != scans.front().scan.lidar) continue;
      scans.push_back({scan->scan, T_map_base_of(scan->true_pose), breaks});
      scans.back().scan.stamp += correction.stamp;
      log.stamps.push_back(scans.back().scan.stamp);
      breaks = false;
    }
  }
  std::sort(periods.begin(), periods.end());
  if (!periods.empty()) log.odometry_period_s = percentile(periods, 0.5);
  return scans;
}

/// Replaces the poses of the scans by those of `mh_amcl`, where it is sure.
void localize(const RecordedPlace& place, Stamp shift, std::vector<RawScan>& scans) {
  constexpr double kSure = 0.9;
  const LocalizerFactory factory(parse_localizers({"mh_amcl"}), {place.map});
  std::vector<NamedLocalizer> localizers = factory.build(1);
  localization::Localizer& localizer = *localizers.front().localizer;
  localizer.initialize(std::nullopt);
  std::size_t next = 0;
  for (const Frame& frame : place.frames) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      localizer.on_odometry(odometry->odometry);
    } else if (const auto* data = std::get_if<ScanFrame>(&frame.data)) {
      localizer.on_scan(data->scan);
      if (next == scans.size() || data->scan.stamp + shift != scans[next].scan.stamp) continue;
      const auto estimate = localizer.estimate();
      const bool sure = estimate && !estimate->lost && estimate->probability >= kSure &&
                        estimate->stamp == data->scan.stamp;
      scans[next++].T_map_base = sure ? std::optional(estimate->T_map_base) : std::nullopt;
    }
  }
}

std::optional<SE2> motion(const TransformBuffer& T_odom_base, Stamp from, Stamp to) {
  const auto T_odom_from = T_odom_base.at(from);
  const auto T_odom_to = T_odom_base.at(to);
  if (!T_odom_from || !T_odom_to) return std::nullopt;
  return T_odom_from->inverse() * *T_odom_to;
}

/// Tracks scans without a pose backwards from the next one that has one.
void track_backwards(const ScanAligner& aligner, const TransformBuffer& T_path_base,
                     std::vector<RawScan>& scans) {
  constexpr double kStepSigma = 0.2;  // [m]
  for (std::size_t i = scans.size() - 1; i-- > 0;) {
    const RawScan& next = scans[i + 1];
    if (scans[i].T_map_base || !next.T_map_base || next.breaks) continue;
    const auto u = motion(T_path_base, next.scan.stamp, scans[i].scan.stamp);
    if (!u) continue;
    scans[i].T_map_base = aligner.align(scans[i].scan, *next.T_map_base * *u, kStepSigma);
  }
}

/// Sets and checks how much of the scans lies on walls.
void check_fit(const ScanAligner& aligner, AlignedLog& log) {
  constexpr std::size_t kChecked = 200;  // Scans.
  std::vector<double> shares;
  for (const std::size_t i : spread_scans(log, kChecked)) {
    shares.push_back(aligner.on_walls(log.scans[i]));
  }
  std::sort(shares.begin(), shares.end());
  log.on_walls = percentile(shares, 0.5);
  if (log.on_walls >= kLeastOnWalls) return;
  throw std::runtime_error(
      fmt::format("{}: {:.0f} % of the scans' end points lie on walls of the map: check that log "
                  "and map belong together (castaway replay shows it)",
                  log.name, 100.0 * log.on_walls));
}

void correct_references(const SE2& T_reference_base, std::vector<RawScan>& scans) {
  for (RawScan& scan : scans) {
    if (scan.T_map_base) scan.T_map_base = *scan.T_map_base * T_reference_base;
  }
}

/// Mean of small motions.
class MeanMotion {
 public:
  void add(const SE2& motion) {
    sum_ += Eigen::Vector3d(motion.x, motion.y, motion.yaw);
    count_ += 1.0;
  }
  [[nodiscard]] SE2 mean() const {
    const Eigen::Vector3d mean = sum_ / std::max(count_, 1.0);
    return {mean.x(), mean.y(), mean.z()};
  }

 private:
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  double count_ = 0.0;
};

bool has_reference_poses(const std::vector<RawScan>& scans) {
  const auto known =
      std::count_if(scans.begin(), scans.end(), [](const auto& s) { return s.T_map_base; });
  return 2 * static_cast<std::size_t>(known) > scans.size();
}

}  // namespace

AlignBy parse_align(const std::string& text) {
  if (text == "auto") return AlignBy::kAuto;
  if (text == "truth") return AlignBy::kTruth;
  if (text == "mh_amcl") return AlignBy::kMhAmcl;
  throw std::invalid_argument("no alignment '" + text + "'; there are auto, truth, mh_amcl");
}

void move_back(AlignedLog& log) {
  const SE2 T_base_start{-log.T_start_base.x, -log.T_start_base.y, 0.0};
  for (AlignedScan& aligned : log.scans) aligned.T_map_base = aligned.T_map_base * T_base_start;
  log.T_start_base = {0.0, 0.0, log.T_start_base.yaw};
}

AlignedLog align_log(const RecordedPlace& place, AlignBy by, const ScanCorrection& correction) {
  constexpr double kReferenceSigma = 0.05;  // [m]
  AlignedLog log;
  log.name = place.name;
  log.stamp_correction = correction.stamp;
  log.grid = to_occupancy_grid(place.map);
  log.T_odom_base = TransformBuffer({.length = Stamp::max() / 4});
  log.T_path_base = log.T_odom_base;
  std::vector<RawScan> scans = take_scans(place, correction, log);
  log.by_truth = by != AlignBy::kMhAmcl && has_reference_poses(scans);
  if (by == AlignBy::kTruth && !log.by_truth) {
    throw std::runtime_error(place.name +
                             ": most of its scans have no reference pose; leave out --align");
  }
  if (log.by_truth) {
    correct_references(correction.T_reference_base, scans);
  } else {
    localize(place, correction.stamp, scans);
  }
  const ScanAligner aligner(log, correction.walls);
  if (!scans.empty()) track_backwards(aligner, log.T_path_base, scans);
  const std::size_t stride = (scans.size() + kMostAligned - 1) / kMostAligned;
  bool breaks = false;
  MeanMotion shift;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    RawScan& raw = scans[i];
    breaks = breaks || raw.breaks;
    if (i % stride != 0) continue;
    const auto pose =
        raw.T_map_base ? aligner.align(raw.scan, *raw.T_map_base, kReferenceSigma) : std::nullopt;
    if (!pose) {
      ++log.left_out;
      continue;
    }
    shift.add(raw.T_map_base->inverse() * *pose);
    log.scans.push_back({std::move(raw.scan), *pose, breaks});
    breaks = false;
  }
  if (log.scans.size() < kFewestAligned) {
    throw std::runtime_error(fmt::format(
        "{}: {} scans can be aligned with the map, and at least {} are needed; check that log and "
        "map belong together (castaway replay shows it)",
        place.name, log.scans.size(), kFewestAligned));
  }
  log.T_start_base = shift.mean();
  check_fit(aligner, log);
  return log;
}

}  // namespace castaway::testbed
