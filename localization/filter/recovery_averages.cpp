#include "localization/filter/recovery_averages.hpp"

#include <algorithm>

namespace castaway::localization {

void RecoveryAverages::add(double mean_weight) {
  slow_ = slow_ == 0.0 ? mean_weight : slow_ + config_.alpha_slow * (mean_weight - slow_);
  fast_ = fast_ == 0.0 ? mean_weight : fast_ + config_.alpha_fast * (mean_weight - fast_);
}

double RecoveryAverages::random_share() const {
  return slow_ > 0.0 ? std::max(0.0, 1.0 - fast_ / slow_) : 0.0;
}

void RecoveryAverages::reset() {
  slow_ = 0.0;
  fast_ = 0.0;
}

}  // namespace castaway::localization
