#include "sim/sensor/range_noise.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/normal_distribution.hpp>

namespace castaway::sim {
namespace {

void require_noise_not_negative(double value, const char* field) {
  if (value >= 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(
      fmt::format("lidar: noise.{} is {}: give 0 or more metres", field, value));
}

}  // namespace

void validate(const RangeNoise& noise) {
  require_noise_not_negative(noise.sigma, "sigma");
  require_noise_not_negative(noise.sigma_relative, "sigma_relative");
  require_noise_not_negative(noise.beam_bias_sigma, "beam_bias_sigma");
  require_noise_not_negative(noise.resolution, "resolution");
  if (!std::isfinite(noise.bias)) throw std::invalid_argument("lidar: noise.bias is not a number");
}

double measure_range(const RangeNoise& noise, double range, double beam_bias, Rng& rng) {
  const double sigma = noise.sigma + noise.sigma_relative * range;
  double measured = range + (noise.bias + beam_bias);
  if (sigma > 0.0) measured += boost::random::normal_distribution<double>(0.0, sigma)(rng);
  if (noise.resolution > 0.0) {
    measured = noise.resolution * std::round(measured / noise.resolution);
  }
  return measured;
}

}  // namespace castaway::sim
