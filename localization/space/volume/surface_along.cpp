#include "localization/space/volume/surface_along.hpp"

namespace castaway::localization {
namespace {

FourPoints advance(const FourPoints& points, const FourPoints& direction, FourFloats by) {
  return {points.x + by * direction.x, points.y + by * direction.y, points.z + by * direction.z};
}

FourFloats surface_ahead(const SurfaceField& surfaces, const FourPoints& from,
                         const FourPoints& direction, float reach) {
  const float near = 0.3F * static_cast<float>(surfaces.resolution());
  const float before = 0.5F * near;  // Not beyond the plane, behind which the distance grows.
  const FourFloats shortest = FourFloats{} + before;
  const FourFloats most = FourFloats{} + reach;
  FourFloats found = most;
  FourFloats t{};
  for (FourInts on_way = t < most; any(on_way);) {
    const auto [distance, rate] = surfaces.rates(advance(from, direction, t), direction);
    const FourFloats there = t + distance / -rate;  // On the plane of the surface.
    const FourInts hit = on_way & (distance < near) & (rate < 0.0F) & (there < most);
    found = hit ? there : found;
    const FourFloats step = distance - before;
    t += step > shortest ? step : shortest;
    on_way &= ~hit & (t < most);
  }
  return found;
}

}  // namespace

FourFloats surface_along(const SurfaceField& surfaces, const FourPoints& from,
                         const FourPoints& direction, float reach) {
  const FourPoints backwards{-direction.x, -direction.y, -direction.z};
  const FourFloats ahead = surface_ahead(surfaces, from, direction, reach);
  const FourFloats back = surface_ahead(surfaces, from, backwards, reach);
  return ahead < back ? ahead : back;
}

}  // namespace castaway::localization
