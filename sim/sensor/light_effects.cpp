#include "sim/sensor/light_effects.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr double kDarkReflectivity = 0.1;  // Reflectivity of the dark target in data sheets.

void require_light(bool condition, const char* field, double value, const char* remedy) {
  if (condition) return;
  throw std::invalid_argument(fmt::format("lidar: noise.{} is {}: {}", field, value, remedy));
}

void require_share(double value, const char* field) {
  require_light(value >= 0.0 && value <= 1.0, field, value, "give a share, 0 to 1");
}

void require_light_not_negative(double value, const char* field) {
  require_light(value >= 0.0 && std::isfinite(value), field, value, "give 0 or more");
}

}  // namespace

void validate(const LightEffects& e) {
  require_light_not_negative(e.dark_range, "dark_range");
  require_share(e.dropout, "dropout");
  require_share(e.dropout_far, "dropout_far");
  require_share(e.dropout_grazing, "dropout_grazing");
  require_share(e.dropout_dark, "dropout_dark");
  require_light_not_negative(e.dust_rate, "dust_rate");
  require_light_not_negative(e.dust_range, "dust_range");
  require_light(e.divergence_deg >= 0.0 && e.divergence_deg < 45.0, "divergence_deg",
                e.divergence_deg, "give 0 to 45 degrees");
  require_light_not_negative(e.mixed_reach, "mixed_reach");
  require_share(e.glass_return, "glass_return");
  require_light(e.glass_angle_deg >= 0.0 && e.glass_angle_deg <= 90.0, "glass_angle_deg",
                e.glass_angle_deg, "give 0 to 90 degrees");
}

bool any(const LightEffects& e) {
  const bool lost = e.dropout > 0.0 || e.dropout_far > 0.0 || e.dropout_grazing > 0.0 ||
                    e.dropout_dark > 0.0 || e.dark_range > 0.0;
  return lost || e.dust_rate > 0.0 || e.divergence_deg > 0.0 || e.glass;
}

double lost_share(const LightEffects& e, double range_per_max, double cosine, double reflectivity) {
  const double far = e.dropout_far * range_per_max * range_per_max;
  const double grazing = e.dropout_grazing * (1.0 - cosine);
  const double dark = e.dropout_dark * (1.0 - reflectivity);
  return 1.0 - (1.0 - e.dropout) * (1.0 - far) * (1.0 - grazing) * (1.0 - dark);
}

double seen_within(const LightEffects& e, double cosine, double reflectivity) {
  if (e.dark_range <= 0.0) return std::numeric_limits<double>::infinity();
  return e.dark_range * std::sqrt(reflectivity * cosine / kDarkReflectivity);
}

}  // namespace castaway::sim
