/// Times to an event, some of which were not observed to the end.
///
/// E. L. Kaplan, P. Meier, "Nonparametric Estimation from Incomplete Observations", JASA 53, 1958.
/// Intervals: Greenwood's variance of log(-log S) (J. D. Kalbfleisch, R. L. Prentice, "The
/// Statistical Analysis of Failure Time Data", 2002, section 1.4).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// A step of a survival curve.
struct SurvivalStep {
  double time_s = 0.0;  ///< [s]
  int at_risk = 0;      ///< Just before.
  int events = 0;
  double survival = 1.0;  ///< From this time on.
  Interval interval;      ///< 95 %, of `survival`.
};

/// The share that still waits for the event, over time. Times are rounded to 10 ms, so that memory
/// does not grow with the sample.
class Survival {
 public:
  /// `event`: false if the observation ended at that time without one. A time below 0 counts as 0.
  void add(double time_s, bool event);

  [[nodiscard]] int size() const { return events_ + censored_; }
  [[nodiscard]] int events() const { return events_; }
  [[nodiscard]] int censored() const { return censored_; }
  /// Of the longest observation. [s]
  [[nodiscard]] double longest_s() const;
  /// One for each time with an event. An observation that ends at the time of an event counts as at
  /// risk.
  [[nodiscard]] std::vector<SurvivalStep> steps() const;
  /// The first time at which no more than half still wait; nothing if it was not observed. [s]
  [[nodiscard]] std::optional<double> median_s() const;

 private:
  struct Counts {
    int events = 0;
    int censored = 0;
  };
  std::map<std::int64_t, Counts> times_;  // By multiples of 10 ms.
  int events_ = 0;
  int censored_ = 0;
};

}  // namespace castaway::testbed
