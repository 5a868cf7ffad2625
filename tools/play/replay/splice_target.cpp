#include "tools/play/replay/splice_target.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "tools/play/replay/spliced_kidnap.hpp"

namespace castaway::testbed {
namespace {

constexpr double kFarthestFromLog = 2.0;  // [m]
constexpr double kPerRadian = 0.5;        // [m/rad]

std::vector<const ScanFrame*> scans_of(const Frames& frames) {
  std::vector<const ScanFrame*> scans;
  for (const Frame& frame : frames) {
    if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) scans.push_back(scan);
  }
  return scans;
}

/// [m] True height of base; 0 if it is unknown.
double true_height(const ScanFrame& scan) { return scan.true_pose ? scan.true_pose->z() : 0.0; }

/// [m] Between two true poses that are known, with their heights.
double distance_between(const ScanFrame& a, const ScanFrame& b) {
  return std::hypot(distance(a.true_pose->T_map_base, b.true_pose->T_map_base),
                    true_height(a) - true_height(b));
}

/// The scan of the least cost; an infinite cost excludes it.
template <typename Cost>
std::size_t cheapest(const std::vector<const ScanFrame*>& scans, Cost cost, const char* missing) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const double c =
        scans[i]->true_pose ? cost(*scans[i]) : std::numeric_limits<double>::infinity();
    if (c >= least) continue;
    least = c;
    best = i;
  }
  if (!std::isfinite(least)) throw std::runtime_error(missing);
  return best;
}

}  // namespace

std::size_t nearest_scan(const Frames& frames, const SE2& T_map_base,
                         const std::function<bool(double z)>& at_height) {
  const auto scans = scans_of(frames);
  const std::size_t best = cheapest(
      scans,
      [&](const ScanFrame& scan) {
        if (!at_height(true_height(scan))) return std::numeric_limits<double>::infinity();
        return distance(scan.true_pose->T_map_base, T_map_base) +
               kPerRadian * yaw_distance(scan.true_pose->T_map_base, T_map_base);
      },
      "the log holds no true poses there: choose a scan to go on from");
  if (distance(scans[best]->true_pose->T_map_base, T_map_base) > kFarthestFromLog) {
    throw std::runtime_error(fmt::format("the log was never within {} m of ({:.2f}, {:.2f}) m",
                                         kFarthestFromLog, T_map_base.x, T_map_base.y));
  }
  return best;
}

std::size_t far_scan(const Frames& frames, std::size_t from, double min_distance_m) {
  const auto scans = scans_of(frames);
  const ScanFrame& here = *scans.at(from);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::size_t to = (from + scans.size() / 2 + i) % scans.size();
    if (!here.true_pose && to != from) return to;
    const bool known = here.true_pose && scans[to]->true_pose;
    if (known && distance_between(here, *scans[to]) >= min_distance_m) return to;
  }
  throw std::runtime_error(
      fmt::format("no scan of the log is {} m away from this one", min_distance_m));
}

std::size_t look_alike_scan(const Frames& frames, std::size_t from, double min_distance_m) {
  const auto scans = scans_of(frames);
  const ScanFrame& here = *scans.at(from);
  return cheapest(
      scans,
      [&](const ScanFrame& scan) {
        const bool elsewhere = here.true_pose && distance_between(here, scan) >= min_distance_m;
        return elsewhere ? range_difference(here.scan, scan.scan, 0.0)
                         : std::numeric_limits<double>::infinity();
      },
      "the log has no other place with a true pose");
}

}  // namespace castaway::testbed
