/// Confidence intervals.
#pragma once

namespace castaway::testbed {

/// Confidence interval of a rate, in [0, 1].
struct RateInterval {
  double low = 0.0;
  double high = 1.0;
};

/// E. B. Wilson's 95 % score interval (JASA 22, 1927) of `successes` in `trials`; [0, 1] if there
/// are no trials.
RateInterval wilson_interval(int successes, int trials);

/// The same for another confidence: `z` is the quantile of the normal distribution that it stands
/// for. `successes` may be a sum of shares.
RateInterval wilson_interval(double successes, double trials, double z);

}  // namespace castaway::testbed
