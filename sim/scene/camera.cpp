#include "sim/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace castaway::sim {
namespace {

constexpr float kNear = 0.05F;
constexpr float kLeastFar = 200.0F;

float far_of(const Camera& camera) {
  return std::max(kLeastFar, 3.0F * (camera.eye - camera.target).norm());
}

Eigen::Matrix4f clip_from_eye(const Camera& camera, float aspect) {
  Eigen::Matrix4f P = Eigen::Matrix4f::Zero();
  const float far = far_of(camera);
  if (camera.ortho_height > 0.0F) {
    P(0, 0) = 2.0F / (camera.ortho_height * aspect);
    P(1, 1) = 2.0F / camera.ortho_height;
    P(2, 2) = -2.0F / (far - kNear);
    P(2, 3) = -(far + kNear) / (far - kNear);
    P(3, 3) = 1.0F;
    return P;
  }
  const float half_angle = 0.5F * camera.fov_y_deg * std::numbers::pi_v<float> / 180.0F;
  const float scale = 1.0F / std::tan(half_angle);
  P(0, 0) = scale / aspect;
  P(1, 1) = scale;
  P(2, 2) = -(far + kNear) / (far - kNear);
  P(2, 3) = -2.0F * far * kNear / (far - kNear);
  P(3, 2) = -1.0F;
  return P;
}

}  // namespace

Eigen::Matrix4f eye_from_map(const Camera& camera) {
  const Eigen::Vector3f backward = (camera.eye - camera.target).normalized();
  const Eigen::Vector3f right = camera.up.cross(backward).normalized();
  Eigen::Matrix4f T = Eigen::Matrix4f::Identity();
  T.block<1, 3>(0, 0) = right.transpose();
  T.block<1, 3>(1, 0) = backward.cross(right).transpose();
  T.block<1, 3>(2, 0) = backward.transpose();
  T.block<3, 1>(0, 3) = -T.block<3, 3>(0, 0) * camera.eye;
  return T;
}

Eigen::Matrix4f clip_from_map(const Camera& camera, float aspect) {
  return clip_from_eye(camera, aspect) * eye_from_map(camera);
}

Camera step_back(Camera camera, const Eigen::AlignedBox3f& box, float aspect) {
  constexpr float kRim = 0.97F;  // Share of the picture.
  constexpr float kStep = 1.02F;
  const auto is_seen = [&](int corner) {
    const Eigen::Vector3f p = box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner));
    const Eigen::Vector4f clip = clip_from_map(camera, aspect) * p.homogeneous();
    return clip.w() > 0.0F && clip.head<2>().cwiseAbs().maxCoeff() <= kRim * clip.w();
  };
  for (int step = 0; step < 200; ++step) {
    bool all = true;
    for (int corner = 0; corner < 8; ++corner) all = all && is_seen(corner);
    if (all) break;
    camera.eye = camera.target + kStep * (camera.eye - camera.target);
  }
  return camera;
}

Eigen::Vector4f viewpoint(const Camera& camera) {
  if (camera.ortho_height <= 0.0F) return camera.eye.homogeneous();
  Eigen::Vector4f direction = Eigen::Vector4f::Zero();
  direction.head<3>() = (camera.eye - camera.target).normalized();
  return direction;
}

}  // namespace castaway::sim
