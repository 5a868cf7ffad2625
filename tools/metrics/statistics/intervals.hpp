/// Confidence intervals.
#pragma once

namespace castaway::testbed {

/// An interval of a rate, in [0, 1].
struct RateInterval {
  double low = 0.0;
  double high = 1.0;
};

/// E. B. Wilson's score interval (JASA 22, 1927) of `successes` in `trials`, 95 %; [0, 1] without
/// trials.
RateInterval wilson_interval(int successes, int trials);

}  // namespace castaway::testbed
