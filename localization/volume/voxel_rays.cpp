#include "localization/volume/voxel_rays.hpp"

#include <algorithm>

namespace castaway::localization {

namespace {

template <typename Distances>
Encounter trace(const Distances& distances, const Eigen::Vector3f& from,
                const Eigen::Vector3f& to) {
  const auto voxel = static_cast<float>(distances.resolution());
  const float length = (to - from).norm();
  if (!(length > 0.0F)) return Encounter::kNone;
  const Eigen::Vector3f direction = (to - from) / length;
  // A point of the voxel's centre that is read may lie half a diagonal away, and the surface point
  // of a voxel as far from the surface.
  const float slack = 0.87F * voxel;
  bool beginning = true;
  bool reached = false;
  for (float t = 0.0F; t < length;) {
    const Eigen::Vector3f p = from + t * direction;
    const float distance = distances.at_point(p);
    const bool touches = distance < 0.75F * voxel;
    if (reached && !touches) return Encounter::kPassed;
    reached = touches && !beginning;
    beginning = beginning && touches;
    t += std::max(distance - slack, 0.5F * voxel);
  }
  return reached ? Encounter::kReached : Encounter::kNone;
}

}  // namespace

Encounter encounter(const VoxelDistances& distances, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to) {
  return trace(distances, from, to);
}

Encounter encounter(const SurfaceField& surfaces, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to) {
  return trace(surfaces, from, to);
}

bool passes_through(const VoxelDistances& distances, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to) {
  const auto passes = [&](const Eigen::Vector3f& beside) {
    return encounter(distances, from + beside, to + beside) == Encounter::kPassed;
  };
  if (!passes(Eigen::Vector3f::Zero())) return false;
  const Eigen::Vector3f direction = (to - from).normalized();
  const auto voxel = static_cast<float>(distances.resolution());
  const Eigen::Vector3f left = voxel * direction.unitOrthogonal();
  const Eigen::Vector3f up = direction.cross(left);
  int missed = 0;
  const int allowed = distances.rough() ? 1 : 0;
  for (const Eigen::Vector3f& side : {left, Eigen::Vector3f(-left), up, Eigen::Vector3f(-up)}) {
    if (!passes(side) && ++missed > allowed) return false;
  }
  return true;
}

}  // namespace castaway::localization
