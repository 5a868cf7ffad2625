#include "localization/map/interpolated_field.hpp"

#include <algorithm>

namespace castaway::localization {
namespace {

constexpr int kBorder = 2;               // cells
constexpr float kFarthestKept = 500.0F;  // cells

/// Caches the values of a function of distance. Distances between cells are square roots of whole
/// numbers of cells, which serve as index.
class CachedFunction {
 public:
  CachedFunction(const std::function<double(double)>& f, const DistanceField& distances)
      : f_(f), per_square_(1.0F / square(static_cast<float>(distances.frame().resolution))) {
    const auto largest = static_cast<float>(distances.max_distance());
    known_.resize(slot(largest) + 1, {-1.0F, 0.0F});
  }

  float operator()(float distance) {
    Known& known = known_[slot(distance)];
    if (known.distance != distance) known = {distance, static_cast<float>(f_(distance))};
    return known.value;
  }

 private:
  struct Known {
    float distance, value;
  };
  static float square(float x) { return x * x; }
  [[nodiscard]] std::size_t slot(float distance) const {
    const float cells = std::min(square(distance) * per_square_, square(kFarthestKept));
    return static_cast<std::size_t>(cells + 0.5F);
  }

  const std::function<double(double)>& f_;
  float per_square_;
  std::vector<Known> known_;
};

}  // namespace

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
  CachedFunction value(f, distances);
  for (int row = 0; row < frame_.height; ++row) {
    for (int column = 0; column < frame_.width; ++column) {
      values_[static_cast<std::size_t>((row + kBorder) * stride_ + column + kBorder)] =
          value(distances.values()[frame_.index({column, row})]);
    }
  }
}

}  // namespace castaway::localization
