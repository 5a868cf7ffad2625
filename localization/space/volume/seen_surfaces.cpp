#include "localization/space/volume/seen_surfaces.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace castaway::localization {
namespace {

constexpr std::int64_t kMostSpace = std::int64_t{1} << 31U;  // [voxels]
constexpr double kAboveGround = 0.15;                        // [m] Where free space begins.

/// The space that a map covers, voxel by voxel.
class Space {
 public:
  explicit Space(const VoxelMap& map) {
    low_ = high_ = voxel_index(map.keys.front());
    for (const VoxelKey key : map.keys) {
      low_ = low_.cwiseMin(voxel_index(key));
      high_ = high_.cwiseMax(voxel_index(key));
    }
    size_ = (high_ - low_).cast<std::int64_t>().array() + 1;
  }

  [[nodiscard]] std::int64_t volume() const { return size_.prod(); }
  [[nodiscard]] bool contains(const Eigen::Vector3i& voxel) const {
    return (voxel.array() >= low_.array()).all() && (voxel.array() <= high_.array()).all();
  }
  [[nodiscard]] std::size_t index(const Eigen::Vector3i& voxel) const {
    const Eigen::Matrix<std::int64_t, 3, 1> v = (voxel - low_).cast<std::int64_t>();
    return static_cast<std::size_t>((v.z() * size_.y() + v.y()) * size_.x() + v.x());
  }
  [[nodiscard]] const Eigen::Vector3i& low() const { return low_; }
  [[nodiscard]] const Eigen::Vector3i& high() const { return high_; }

 private:
  Eigen::Vector3i low_, high_;
  Eigen::Matrix<std::int64_t, 3, 1> size_;
};

/// Fills free space, row by row along x, from where it is known to be reached.
class Flood {
 public:
  Flood(const Space& space, const VoxelMap& map)
      : space_(space), closed_(static_cast<std::size_t>(space.volume()), false), reached_(closed_) {
    for (const VoxelKey key : map.keys) closed_[space.index(voxel_index(key))] = true;
  }

  void from(const Eigen::Vector3i& voxel) {
    if (space_.contains(voxel)) rows_.push_back(voxel);
    while (!rows_.empty()) {
      const Eigen::Vector3i next = rows_.back();
      rows_.pop_back();
      if (is_open(next)) fill_row(next);
    }
  }
  [[nodiscard]] bool reached(const Eigen::Vector3i& voxel) const {
    return space_.contains(voxel) && reached_[space_.index(voxel)];
  }

 private:
  [[nodiscard]] bool is_open(const Eigen::Vector3i& voxel) const {
    return !closed_[space_.index(voxel)];
  }

  void fill_row(const Eigen::Vector3i& voxel) {
    Eigen::Vector3i first = voxel;
    while (first.x() > space_.low().x() && is_open(first - Eigen::Vector3i::UnitX())) --first.x();
    Eigen::Vector3i last = voxel;
    while (last.x() < space_.high().x() && is_open(last + Eigen::Vector3i::UnitX())) ++last.x();
    for (std::size_t i = space_.index(first); i <= space_.index(last); ++i) {
      closed_[i] = reached_[i] = true;
    }
    for (const Eigen::Vector3i& side : {Eigen::Vector3i(0, -1, 0), Eigen::Vector3i(0, 1, 0),
                                        Eigen::Vector3i(0, 0, -1), Eigen::Vector3i(0, 0, 1)}) {
      note_openings(first + side, last.x());
    }
  }

  /// Notes the first voxel of each open stretch of a row, up to `last` in x.
  void note_openings(Eigen::Vector3i voxel, int last) {
    if (!space_.contains(voxel)) return;
    bool was_open = false;
    for (; voxel.x() <= last; ++voxel.x()) {
      const bool open = is_open(voxel);
      if (open && !was_open) rows_.push_back(voxel);
      was_open = open;
    }
  }

  const Space& space_;
  std::vector<bool> closed_;  ///< By a surface, or because it has been filled.
  std::vector<bool> reached_;
  std::vector<Eigen::Vector3i> rows_;
};

void flood_from_ground(const ElevationMap& ground, double resolution, Flood& flood) {
  const GridFrame& frame = ground.frame;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const Eigen::Vector2d p = frame.T_map_grid * frame.centre_of({column, row});
      for (const GroundSurface& surface : ground.at({column, row})) {
        if (!surface.drivable) continue;
        flood.from(voxel_of({p.x(), p.y(), surface.z + kAboveGround}, resolution));
      }
    }
  }
}

bool is_seen(const Flood& flood, const Eigen::Vector3i& voxel) {
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (flood.reached(voxel + Eigen::Vector3i(x, y, z))) return true;
      }
    }
  }
  return false;
}

}  // namespace

VoxelMap seen_surfaces(const VoxelMap& voxels, const ElevationMap& ground) {
  if (voxels.size() == 0) return voxels;
  const Space space(voxels);
  if (space.volume() > kMostSpace) return voxels;
  Flood flood(space, voxels);
  flood_from_ground(ground, voxels.resolution, flood);
  VoxelMap seen;
  seen.resolution = voxels.resolution;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (!is_seen(flood, voxel_index(voxels.keys[i]))) continue;
    seen.keys.push_back(voxels.keys[i]);
    seen.offsets.push_back(voxels.offsets[i]);
    seen.faces_up.push_back(voxels.faces_up[i]);
  }
  return seen;
}

}  // namespace castaway::localization
