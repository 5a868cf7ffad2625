/// Colours by what an observation model says of an end point.
#pragma once

#include <Eigen/Core>

#include "localization/sensor/endpoint_model.hpp"

namespace castaway::testbed {

inline const Eigen::Vector3f kFreeColor{0.98F, 0.97F, 0.94F};
inline const Eigen::Vector3f kCostColor{0.25F, 0.45F, 0.78F};  ///< Of ground on which beams end.

/// Likelihood of an end point at `distance` [m] from a surface, relative to one on a surface.
float endpoint_likelihood(const localization::EndpointConfig& model, double distance);

/// From 0 for the least likelihood to 1 for that of a point on a surface.
float fit_of(const localization::EndpointConfig& model, float likelihood);

/// `a` for a share of 0, `b` for 1; of colours or points.
inline Eigen::Vector3f mix(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float share) {
  return a + share * (b - a);
}

/// Colour of an end point, and of its beam: red for the least likelihood, green for 1.
Eigen::Vector3f likelihood_color(const localization::EndpointConfig& model, float likelihood);

/// Colour of ground at `distance` [m] from a surface: the bluer the likelier a beam ends there.
Eigen::Vector3f cost_color(const localization::EndpointConfig& model, double distance,
                           const Eigen::Vector3f& free = kFreeColor);

}  // namespace castaway::testbed
