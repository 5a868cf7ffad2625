#include "sim/scene/light_frame.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kLeastReach = 8.0F;  // [m]
constexpr float kFocus = 0.7F;       // Share of the reach, ahead of the camera.
constexpr float kBorder = 1.1F;      // Room for the map's faded border.

/// Light coordinates: x right and y up as the sun sees them, z towards it.
Eigen::Matrix3f light_from_map() {
  Eigen::Matrix3f R;
  R.row(2) = to_sun();
  R.row(0) = Vector3f::UnitY().cross(to_sun()).normalized();
  R.row(1) = R.row(2).cross(R.row(0));
  return R;
}

Eigen::AlignedBox3f rotate_box(const Eigen::AlignedBox3f& bounds, const Eigen::Matrix3f& R) {
  Eigen::AlignedBox3f box;
  for (int corner = 0; corner < 8; ++corner) {
    box.extend(R * bounds.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)));
  }
  return box;
}

/// The centre of the visible area, on the ground.
Vector3f focus_of(const Camera& camera, float reach, float ground) {
  const Vector2f ahead = (camera.target - camera.eye).head<2>();
  const float way = ahead.norm();
  Vector3f focus = camera.eye;
  if (way > 1e-3F) focus.head<2>() += kFocus * reach / way * ahead;
  focus.z() = ground;
  return focus;
}

}  // namespace

Vector3f to_sun() { return Vector3f(-0.45F, -0.6F, 1.2F).normalized(); }

LightFrame light_frame(const Camera& camera, const Eigen::AlignedBox3f& bounds, int texels) {
  const Eigen::Matrix3f R = light_from_map();
  const Eigen::AlignedBox3f lit = rotate_box(bounds, R);
  const float reach = std::max(kLeastReach, 2.0F * (camera.target - camera.eye).norm());
  const Vector3f focus = R * focus_of(camera, reach, bounds.min().z());
  LightFrame frame;
  frame.clip_from_map.topLeftCorner<3, 3>() = R;
  frame.texel_m = 0.0F;
  for (int axis = 0; axis < 2; ++axis) {
    const float whole = std::max(0.5F * kBorder * lit.sizes()(axis), 0.1F);
    const float half = std::min(reach, whole);
    const float cell = 2.0F * half / static_cast<float>(texels);
    const float center =
        whole <= reach ? lit.center()(axis) : std::round(focus(axis) / cell) * cell;
    frame.clip_from_map.row(axis) /= half;
    frame.clip_from_map(axis, 3) = -center / half;
    frame.texel_m = std::max(frame.texel_m, cell);
  }
  const float deep = 0.5F * lit.sizes().z() + 0.1F;
  frame.clip_from_map.row(2) /= -deep;
  frame.clip_from_map(2, 3) = lit.center().z() / deep;
  return frame;
}

}  // namespace castaway::sim
