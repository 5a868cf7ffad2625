#include "tools/twin/likeness.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "localization/mh_amcl/mh_amcl_models.hpp"
#include "tools/twin/alignment/expected_scan.hpp"
#include "tools/twin/alignment/motion_samples.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kLikeScans = 500;

/// Samples of one log, by quantity.
struct LogSamples {
  std::vector<double> residuals_m;
  std::vector<double> blocked;
  std::vector<double> drift_percent;
  std::vector<double> evidence;
};

/// Adds the residuals of a scan's ranges on straight walls, and its share of blocked beams.
void add_ranges(const AlignedLog& log, const AlignedScan& aligned, LogSamples& samples) {
  constexpr double kNearWall = 0.3;      // [m]
  constexpr std::size_t kEachBeam = 10;  // Neighbouring beams see the same wall.
  const LaserScan& scan = aligned.scan;
  const auto expected = expect_scan(log, aligned, std::min(scan.range_max, 40.0));
  double beams = 0.0;
  double blocked = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double residual = scan.ranges[i] - expected[i].range;
    if (!expected[i].straight || std::isnan(residual)) continue;
    beams += 1.0;
    if (residual < -kNearWall) blocked += 1.0;
    if (i % kEachBeam == 0 && std::abs(residual) < kNearWall) {
      samples.residuals_m.push_back(residual);
    }
  }
  if (beams > 0.0) samples.blocked.push_back(blocked / beams);
}

LogSamples sample_log(const AlignedLog& log) {
  const localization::MhAmclModels models({}, log.grid);
  LogSamples samples;
  for (const std::size_t i : spread_scans(log, kLikeScans)) {
    const AlignedScan& aligned = log.scans[i];
    add_ranges(log, aligned, samples);
    const auto points = project_scan(aligned.scan, log.T_path_base, aligned.scan.stamp, {});
    if (!points || points->empty()) continue;
    samples.evidence.push_back(
        models.evidence.evaluate(*points, aligned.T_map_base).log_likelihood);
  }
  constexpr double kLength = 10.0;  // [m]
  for (const Drift& drift : drifts_over(log, kLength)) {
    samples.drift_percent.push_back(100.0 * drift.miss_m / drift.way_m);
  }
  for (auto* values :
       {&samples.residuals_m, &samples.blocked, &samples.drift_percent, &samples.evidence}) {
    std::sort(values->begin(), values->end());
  }
  return samples;
}

std::vector<DriftPoint> compare_drift(const AlignedLog& log, const AlignedLog& twin) {
  std::vector<DriftPoint> points;
  for (const double length : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) {
    const auto in_log = drift_rms(drifts_over(log, length));
    const auto in_twin = drift_rms(drifts_over(twin, length));
    if (in_log && in_twin) points.push_back({length, *in_log, *in_twin});
  }
  return points;
}

}  // namespace

std::vector<Drift> drifts_over(const AlignedLog& log, double length) {
  std::vector<Drift> drifts;
  std::vector<OdometryStep> steps;
  SE2 T_start_end;
  double way = 0.0;
  const auto restart = [&] {
    steps.clear();
    T_start_end = {};
    way = 0.0;
  };
  for (const Leg& leg : take_legs(log, kTwinTrack)) {
    if (leg.breaks) {
      restart();
      continue;
    }
    steps.insert(steps.end(), leg.steps.begin(), leg.steps.end());
    T_start_end = T_start_end * leg.T_start_end;
    way += leg.way;
    if (way < length) continue;
    const SE2 miss = T_start_end.inverse() * correct_motion(steps, {});
    drifts.push_back({way, std::hypot(miss.x, miss.y)});
    restart();
  }
  return drifts;
}

std::optional<double> drift_rms(const std::vector<Drift>& drifts) {
  constexpr std::size_t kFewest = 4;
  if (drifts.size() < kFewest) return std::nullopt;
  double squares = 0.0;
  for (const Drift& drift : drifts) squares += drift.miss_m * drift.miss_m;
  return std::sqrt(squares / static_cast<double>(drifts.size()));
}

double wasserstein_distance(const std::vector<double>& a, const std::vector<double>& b) {
  assert(!a.empty() && !b.empty());
  double area = 0.0;
  std::size_t i = 0;
  std::size_t j = 0;
  double at = std::min(a.front(), b.front());
  while (i < a.size() || j < b.size()) {
    const double next = j == b.size() || (i < a.size() && a[i] <= b[j]) ? a[i] : b[j];
    const double below_a = static_cast<double>(i) / static_cast<double>(a.size());
    const double below_b = static_cast<double>(j) / static_cast<double>(b.size());
    area += std::abs(below_a - below_b) * (next - at);
    at = next;
    while (i < a.size() && a[i] <= at) ++i;
    while (j < b.size() && b[j] <= at) ++j;
  }
  return area;
}

Likeness compare_logs(const AlignedLog& log, const AlignedLog& twin) {
  LogSamples a = sample_log(log);
  LogSamples b = sample_log(twin);
  Likeness likeness{{}, compare_drift(log, twin)};
  std::vector<LikeSamples>& all = likeness.samples;
  const auto add = [&](const char* name, const char* unit,
                       std::vector<double> LogSamples::*values) {
    if ((a.*values).empty() || (b.*values).empty()) return;
    all.push_back({name, unit, std::move(a.*values), std::move(b.*values)});
  };
  add("range residual", "m", &LogSamples::residuals_m);
  add("beams blocked", "", &LogSamples::blocked);
  add("odometry error over 10 m", "%", &LogSamples::drift_percent);
  add("evidence", "nats", &LogSamples::evidence);
  return likeness;
}

}  // namespace castaway::testbed
