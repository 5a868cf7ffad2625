#include "tools/twin/drift.hpp"

#include <cmath>

#include "tools/twin/alignment/motion_samples.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {

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

}  // namespace castaway::testbed
