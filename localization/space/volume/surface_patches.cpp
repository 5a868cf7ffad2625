#include "localization/space/volume/surface_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Eigenvalues>

namespace castaway::localization {
namespace {

constexpr float kEnd = 0.75F;       // [voxels] From the mean surface point.
constexpr float kSpread = 0.1F;     // [voxels^2] Least variance along a plane or a line.
constexpr float kOffPlane = 0.35F;  // [voxels] Points farther off belong to another surface.

/// Points of a voxel and of those around it.
class Neighbourhood {
 public:
  void clear() { count_ = 0; }
  void add(const Eigen::Vector3f& p) { points_[count_++] = p; }
  [[nodiscard]] std::span<const Eigen::Vector3f> points() const {
    return std::span(points_).first(count_);
  }

 private:
  std::array<Eigen::Vector3f, 27> points_;
  std::size_t count_ = 0;
};

/// Finds the voxels around each of the map's, taken in their order: nine rows of three are followed
/// through the keys.
class NeighbourWalk {
 public:
  explicit NeighbourWalk(const VoxelMap& map) : map_(map) {}

  /// Points in and around voxel `i`, from its mean surface point, in edges of a voxel.
  void collect(std::size_t i, Neighbourhood& around) {
    around.clear();
    const Eigen::Vector3i centre = voxel_index(map_.keys[i]);
    const Eigen::Vector3f own = within(i);
    for (std::size_t row = 0; row < next_.size(); ++row) {
      const Eigen::Vector3i first(-1, static_cast<int>(row % 3) - 1, static_cast<int>(row / 3) - 1);
      const Eigen::Vector3i from = centre + first;
      if (from.cwiseAbs().maxCoeff() > kMaxVoxelIndex) continue;
      const VoxelKey key = voxel_key(from);
      std::size_t& at = next_[row];
      while (at < map_.size() && map_.keys[at] < key) ++at;
      for (std::size_t k = at; k < map_.size() && map_.keys[k] <= key + 2; ++k) {
        const Eigen::Vector3i step =
            first + Eigen::Vector3i(static_cast<int>(map_.keys[k] - key), 0, 0);
        around.add(step.cast<float>() + within(k) - own);
      }
    }
  }

 private:
  [[nodiscard]] Eigen::Vector3f within(std::size_t i) const {
    const auto& offset = map_.offsets[i];
    return Eigen::Vector3f(offset[0], offset[1], offset[2]) / 256.0F;
  }

  const VoxelMap& map_;
  std::array<std::size_t, 9> next_{};
};

/// Principal axes of points about their mean.
struct Axes {
  Eigen::Vector3f mean;
  Eigen::Vector3f variances;  ///< Ascending.
  Eigen::Matrix3f directions;
};

template <typename Keep>
Axes axes_of(std::span<const Eigen::Vector3f> points, const Keep& keep) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
  float count = 0.0F;
  for (const Eigen::Vector3f& p : points) {
    if (!keep(p)) continue;
    sum += p;
    squares += p * p.transpose();
    count += 1.0F;
  }
  const Eigen::Vector3f mean = sum / count;
  const Eigen::Matrix3f covariance = squares / count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance);
  return {mean, solver.eigenvalues(), solver.eigenvectors()};
}

SurfacePatch patch_of(std::span<const Eigen::Vector3f> points) {
  const Axes all = axes_of(points, [](const Eigen::Vector3f&) { return true; });
  if (!(all.variances[2] > kSpread)) return {};
  if (!(all.variances[1] > kSpread)) return {all.directions.col(2), PatchShape::kLine};
  const Eigen::Vector3f normal = all.directions.col(0);
  const auto on_plane = [&](const Eigen::Vector3f& p) {
    return p.isZero() || std::abs(normal.dot(p - all.mean)) <= kOffPlane;
  };
  const Axes near = std::ranges::all_of(points, on_plane) ? all : axes_of(points, on_plane);
  const bool planar = near.variances[1] > kSpread;
  return {planar ? near.directions.col(0).eval() : normal, PatchShape::kPlane};
}

/// What of a way along a patch is beyond its end.
Eigen::Vector3f beyond_end(const Eigen::Vector3f& along) {
  const float length = along.norm();
  return length > kEnd ? (along * (1.0F - kEnd / length)).eval() : Eigen::Vector3f::Zero();
}

}  // namespace

std::vector<SurfacePatch> surface_patches(const VoxelMap& map) {
  std::vector<SurfacePatch> patches;
  patches.reserve(map.size());
  NeighbourWalk walk(map);
  Neighbourhood around;
  for (std::size_t i = 0; i < map.size(); ++i) {
    walk.collect(i, around);
    patches.push_back(patch_of(around.points()));
  }
  return patches;
}

Eigen::Vector3f way_from(const SurfacePatch& patch, const Eigen::Vector3f& p) {
  const Eigen::Vector3f on_axis = patch.axis.dot(p) * patch.axis;
  switch (patch.shape) {
    case PatchShape::kPlane:
      return on_axis + beyond_end(p - on_axis);
    case PatchShape::kLine:
      return p - on_axis + beyond_end(on_axis);
    case PatchShape::kPoint:
      break;
  }
  return p;
}

}  // namespace castaway::localization
