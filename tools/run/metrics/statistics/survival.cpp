#include "tools/run/metrics/statistics/survival.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kTick = 0.01;  // [s]

/// `greenwood`: sum of events / (at risk * survivors).
Interval log_log_interval(double survival, double greenwood) {
  if (survival <= 0.0 || survival >= 1.0) return {survival, survival};
  constexpr double kNormal = 1.959963984540054;  // 97.5 % quantile of the normal distribution
  const double spread = kNormal * std::sqrt(greenwood) / std::abs(std::log(survival));
  return {std::pow(survival, std::exp(spread)), std::pow(survival, std::exp(-spread))};
}

}  // namespace

void Survival::add(double time_s, bool event) {
  Counts& counts = times_[std::llround(std::max(time_s, 0.0) / kTick)];
  ++(event ? counts.events : counts.censored);
  ++(event ? events_ : censored_);
}

double Survival::longest_s() const {
  return times_.empty() ? 0.0 : kTick * static_cast<double>(times_.rbegin()->first);
}

std::vector<SurvivalStep> Survival::steps() const {
  std::vector<SurvivalStep> steps;
  int at_risk = size();
  double survival = 1.0;
  double greenwood = 0.0;
  for (const auto& [ticks, counts] : times_) {
    if (counts.events > 0) {
      const double left = at_risk - counts.events;
      survival *= left / at_risk;
      greenwood += counts.events / (at_risk * std::max(left, 1.0));
      steps.push_back({kTick * static_cast<double>(ticks), at_risk, counts.events, survival,
                       log_log_interval(survival, greenwood)});
    }
    at_risk -= counts.events + counts.censored;
  }
  return steps;
}

std::optional<double> Survival::median_s() const {
  constexpr double kRounding = 1e-12;
  for (const SurvivalStep& step : steps()) {
    if (step.survival <= 0.5 + kRounding) return step.time_s;
  }
  return std::nullopt;
}

}  // namespace castaway::testbed
