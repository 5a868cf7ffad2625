#include "localization/hypotheses/blindness.hpp"

#include <cmath>

namespace castaway::localization {

void Blindness::take(Stamp now, std::size_t points) {
  if (points > 0) sight_ = Sight{now, points};
  now_ = now;
}

double Blindness::unmoved() const {
  constexpr std::size_t kFaded = 10;  // End points of a last glimpse.
  if (half_life_ <= 0.0 || !sight_ || sight_->points < kFaded) return 1.0;
  return std::exp2(-seconds(now_ - sight_->stamp) / half_life_);
}

}  // namespace castaway::localization
