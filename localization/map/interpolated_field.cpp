#include "localization/map/interpolated_field.hpp"

namespace castaway::localization {
namespace {
constexpr int kBorder = 2;  // cells
}

InterpolatedField::InterpolatedField(const DistanceField& distances,
                                     const std::function<double(double)>& f)
    : frame_(distances.frame()),
      stride_(frame_.width + 2 * kBorder),
      max_u_(static_cast<float>(frame_.width + 2 * kBorder) - 1.001F),
      max_v_(static_cast<float>(frame_.height + 2 * kBorder) - 1.001F) {
  const auto outside = static_cast<float>(f(distances.max_distance()));
  values_.assign(
      static_cast<std::size_t>(stride_) * static_cast<std::size_t>(frame_.height + 2 * kBorder),
      outside);
  for (int row = 0; row < frame_.height; ++row) {
    for (int column = 0; column < frame_.width; ++column) {
      const double d = distances.values()[frame_.index({column, row})];
      values_[static_cast<std::size_t>((row + kBorder) * stride_ + column + kBorder)] =
          static_cast<float>(f(d));
    }
  }
}

}  // namespace castaway::localization
