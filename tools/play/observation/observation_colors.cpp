#include "tools/play/observation/observation_colors.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {

using Eigen::Vector3f;
using localization::EndpointConfig;

float endpoint_likelihood(const EndpointConfig& model, double distance) {
  return static_cast<float>(std::exp(localization::endpoint_log_likelihood(model, distance)));
}

float fit_of(const EndpointConfig& model, float likelihood) {
  constexpr double kFar = 1e6;  // [m]
  const float least = endpoint_likelihood(model, kFar);
  return std::clamp((likelihood - least) / (1.0F - least), 0.0F, 1.0F);
}

Vector3f likelihood_color(const EndpointConfig& model, float likelihood) {
  const Vector3f bad(0.82F, 0.10F, 0.12F);
  const Vector3f half(0.95F, 0.68F, 0.10F);
  const Vector3f good(0.10F, 0.62F, 0.22F);
  const float fit = fit_of(model, likelihood);
  return fit < 0.5F ? mix(bad, half, 2.0F * fit) : mix(half, good, 2.0F * fit - 1.0F);
}

Vector3f cost_color(const EndpointConfig& model, double distance, const Vector3f& free) {
  return mix(free, kCostColor, fit_of(model, endpoint_likelihood(model, distance)));
}

}  // namespace castaway::testbed
