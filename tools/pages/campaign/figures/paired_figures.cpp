#include "tools/pages/campaign/figures/paired_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/run/metrics/statistics/sign_flip.hpp"

namespace castaway::testbed {
namespace {

constexpr std::int64_t kMostFlipped = 2000;

bool are_one_kidnap(const ScoredKidnap& a, const ScoredKidnap& b) {
  constexpr double kSameTime = 1e-3;  // [s]
  return a.number == b.number && a.kidnap.kind == b.kidnap.kind &&
         std::abs(a.kidnap.at_s - b.kidnap.at_s) < kSameTime;
}

PairedTest share_test(const PairedFigures& pair) {
  const PairedOutcomes& outcomes = pair.recoveries;
  return {pair.first,
          pair.second,
          "recovered",
          outcomes.trials(),
          pair.success.mean().blocks(),
          outcomes.difference(),
          paired_difference_interval(outcomes),
          mcnemar_p_value(outcomes),
          1.0,
          fmt::format("{} to {}", outcomes.only_first, outcomes.only_second)};
}

PairedTest mean_test(const PairedFigures& pair, const std::string& figure,
                     const PairedMean& differences) {
  const BlockedMean& mean = differences.mean();
  return {pair.first,
          pair.second,
          figure,
          mean.count(),
          mean.blocks(),
          mean.mean(),
          mean.interval(),
          differences.p_value(fmt::format("campaign/{}/{}/{}", figure, pair.first, pair.second)),
          1.0,
          ""};
}

/// A difference of shares is in [-1, 1].
void limit_to_shares(std::optional<Interval>& interval) {
  if (interval) interval = Interval{std::max(-1.0, interval->low), std::min(1.0, interval->high)};
}

}  // namespace

void PairedMean::add(double difference, std::uint64_t seed) {
  const std::int64_t before = mean_.blocks();
  mean_.add(difference, seed);
  if (mean_.blocks() > kMostFlipped) return;
  if (mean_.blocks() > before) totals_.push_back(0.0);
  totals_.back() += difference;
}

double PairedMean::p_value(const std::string& stream) const {
  return mean_.blocks() <= kMostFlipped ? sign_flip_p_value(totals_, stream) : mean_.p_value();
}

void PairedFigures::add(const PairedCell& a, const PairedCell& b) {
  if (a.tracking_error_m && b.tracking_error_m) {
    tracking_error_m.add(*a.tracking_error_m - *b.tracking_error_m, a.seed);
  }
  for (const ScoredKidnap& in_a : a.kidnaps) {
    const auto in_b = std::find_if(b.kidnaps.begin(), b.kidnaps.end(),
                                   [&](const auto& each) { return are_one_kidnap(in_a, each); });
    if (in_b == b.kidnaps.end()) continue;
    recoveries.add(in_a.kidnap.recovered, in_b->kidnap.recovered);
    success.add(double(in_a.kidnap.recovered) - double(in_b->kidnap.recovered), a.seed);
    time_lost_s.add(in_a.lost_s - in_b->lost_s, a.seed);
    if (in_a.kidnap.time_s && in_b->kidnap.time_s) {
      recovery_time_s.add(*in_a.kidnap.time_s - *in_b->kidnap.time_s, a.seed);
    }
  }
}

LocalizerPairs::LocalizerPairs(std::size_t series) {
  for (std::size_t i = 0; i < series; ++i) {
    for (std::size_t k = i + 1; k < series; ++k) {
      pairs_.emplace_back();
      pairs_.back().first = i;
      pairs_.back().second = k;
    }
  }
}

void LocalizerPairs::add(const std::vector<PairedCell>& cells) {
  for (PairedFigures& pair : pairs_) {
    for (const PairedCell& a : cells) {
      for (const PairedCell& b : cells) {
        if (a.series == pair.first && b.series == pair.second) pair.add(a, b);
      }
    }
  }
}

std::vector<PairedTest> paired_tests(const LocalizerPairs& pairs) {
  std::vector<PairedTest> tests;
  for (const PairedFigures& pair : pairs.pairs()) {
    if (pair.recoveries.trials() > 0) tests.push_back(share_test(pair));
    const auto add_mean = [&](const char* figure, const PairedMean& differences) {
      if (differences.mean().count() > 0) tests.push_back(mean_test(pair, figure, differences));
    };
    add_mean("recovered, by seed", pair.success);
    if (pair.success.mean().count() > 0) limit_to_shares(tests.back().interval);
    add_mean("time to recovery [s]", pair.recovery_time_s);
    add_mean("time lost [s]", pair.time_lost_s);
    add_mean("tracking error [m]", pair.tracking_error_m);
  }
  std::vector<double> p_values;
  for (const PairedTest& test : tests) p_values.push_back(test.p_value);
  const std::vector<double> corrected = holm(p_values);
  for (std::size_t i = 0; i < tests.size(); ++i) tests[i].corrected = corrected[i];
  return tests;
}

}  // namespace castaway::testbed
