#include "sim/sensor/beam_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/random/exponential_distribution.hpp>
#include <boost/random/uniform_01.hpp>

#include "sim/casting/ray_normals.hpp"

namespace castaway::sim {
namespace {

constexpr int kMaxPanes = 8;  // Glass panes that one beam can pass.
constexpr double kRadians = std::numbers::pi / 180.0;

double uniform(Rng& rng) { return boost::random::uniform_01<double>()(rng); }

}  // namespace

double BeamLight::cosine(const Surroundings& around, const Ray& ray, const Echo& echo) const {
  if (echo.object == kHitFloor) return std::abs(ray.direction.z());
  if (is_person(echo.object)) return incidence_cosine(*around.moving, echo.object, ray);
  return incidence_cosine(around.fixed.primitives()[echo.primitive], ray, echo.range);
}

/// The range counts from the device, whatever number of panes the light passed.
Echo BeamLight::first_mirror(const Surroundings& around, Ray ray, Rng& rng,
                             std::uint32_t guess) const {
  const double within = std::cos(effects_.glass_angle_deg * kRadians);
  bool met = false;
  double travelled = 0.0;
  for (int pane = 0; pane <= kMaxPanes && travelled < range_max_; ++pane) {
    Echo echo = first_echo(around, ray, range_max_ - travelled, guess);
    if (!echo.met) break;
    met = true;
    const double incidence = cosine(around, ray, echo);
    const bool glass = effects_.glass && surfaces_.of(echo.object).glass;
    const bool mirrored = glass && incidence >= within && uniform(rng) < effects_.glass_return;
    if (!glass || mirrored) {
      echo.range += travelled;
      echo.cosine = mirrored ? 1.0 : incidence;
      echo.reflectivity = mirrored ? 1.0 : surfaces_.of(echo.object).reflectivity;
      return echo;
    }
    const double way = exit_distance(around.fixed.primitives()[echo.primitive], ray, echo.range);
    ray.origin += way * ray.direction;
    travelled += way;
  }
  return {kNoHit, kHitNothing, guess, 1.0, 0.0, met};
}

/// The edges of the beam hit surfaces at other ranges than its middle: the reported range lies
/// between.
double BeamLight::mix_ranges(const Surroundings& around, const Ray& ray,
                             const Eigen::Vector3d& across, const Echo& echo, Rng& rng) const {
  const double offset = std::tan(0.5 * effects_.divergence_deg * kRadians);
  const double share = uniform(rng);
  double near = echo.range;
  double far = echo.range;
  for (const double side : {-offset, offset}) {
    const Ray edge{ray.origin, (ray.direction + side * across).normalized()};
    const Echo other = first_echo(around, edge, echo.range + effects_.mixed_reach, kNoPrimitive);
    if (other.object == kHitNothing) continue;
    if (echo.range - other.range > effects_.mixed_reach) continue;
    if (effects_.glass && surfaces_.of(other.object).glass) continue;
    near = std::min(near, other.range);
    far = std::max(far, other.range);
  }
  return near + share * (far - near);
}

bool BeamLight::is_lost(const Echo& echo, Rng& rng) const {
  const double share = uniform(rng);
  if (echo.range > seen_within(effects_, echo.cosine, echo.reflectivity)) return true;
  return share < lost_share(effects_, echo.range / range_max_, echo.cosine, echo.reflectivity);
}

/// Dust comes last, so that it does not shift the draws of other effects.
Echo BeamLight::echo(const Surroundings& around, const Ray& ray, const Eigen::Vector3d& across,
                     LidarDraws& draws, std::uint32_t guess) const {
  Echo echo = first_mirror(around, ray, draws.glass, guess);
  if (effects_.divergence_deg > 0.0 && echo.object != kHitNothing) {
    echo.range = mix_ranges(around, ray, across, echo, draws.edges);
  }
  if (echo.object != kHitNothing && is_lost(echo, draws.dropout)) {
    echo = {kNoHit, kHitNothing, echo.primitive, 1.0, 0.0, true};
  }
  if (effects_.dust_rate <= 0.0) return echo;
  const double grain =
      boost::random::exponential_distribution<double>(effects_.dust_rate)(draws.dust);
  if (grain >= std::min({effects_.dust_range, range_max_, echo.range})) return echo;
  return {grain, kHitDust, echo.primitive, 1.0, surfaces_.of(kHitDust).reflectivity, echo.met};
}

}  // namespace castaway::sim
