#include "localization/map/wall_clearance.hpp"

#include <algorithm>

namespace castaway::localization {

WallClearance::WallClearance(const DistanceField& distances) : frame_(distances.frame()) {
  constexpr float kRounding = 1e-3F;  // Whole cells stay whole in single precision.
  const auto scale = static_cast<float>(2.0 / frame_.resolution);
  values_.reserve(distances.values().size());
  for (const float d : distances.values()) {
    values_.push_back(static_cast<std::uint8_t>(std::min(d * scale + kRounding, 255.0F)));
  }
}

}  // namespace castaway::localization
