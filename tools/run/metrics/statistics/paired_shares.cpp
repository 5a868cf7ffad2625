#include "tools/run/metrics/statistics/paired_shares.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>

namespace castaway::testbed {

void PairedOutcomes::add(bool first, bool second) {
  int& count = first ? (second ? both : only_first) : (second ? only_second : neither);
  ++count;
}

double PairedOutcomes::difference() const {
  if (trials() == 0) return 0.0;
  return static_cast<double>(only_first - only_second) / trials();
}

double mcnemar_p_value(const PairedOutcomes& outcomes) {
  const int discordant = outcomes.only_first + outcomes.only_second;
  if (discordant == 0) return 1.0;
  const boost::math::binomial coin(discordant, 0.5);
  const int fewer = std::min(outcomes.only_first, outcomes.only_second);
  return std::min(1.0, 2.0 * boost::math::cdf(coin, fewer));
}

Interval paired_difference_interval(const PairedOutcomes& outcomes) {
  constexpr double kZ = 1.959963984540054;  // 97.5 % quantile of the normal distribution
  const double n = outcomes.trials() + 2.0;
  const double difference = (outcomes.only_first - outcomes.only_second) / n;
  const double discordant = (outcomes.only_first + outcomes.only_second + 1.0) / n;
  const double half = kZ * std::sqrt((discordant - difference * difference) / n);
  return {std::max(-1.0, difference - half), std::min(1.0, difference + half)};
}

}  // namespace castaway::testbed
