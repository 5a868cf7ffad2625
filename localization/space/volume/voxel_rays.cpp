#include "localization/space/volume/voxel_rays.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "localization/geometry/four_floats.hpp"

namespace castaway::localization {

namespace {

void set(FourPoints& four, int k, const Eigen::Vector3f& vector) {
  four.x[k] = vector.x();
  four.y[k] = vector.y();
  four.z[k] = vector.z();
}

/// Four rays that are traced in step. Masks: -1 is true.
struct FourRays {
  FourPoints from{};
  FourPoints direction{};  ///< Unit vectors.
  FourFloats length{};     ///< [m]
  FourFloats t{};          ///< [m] How far they are.
  FourInts on_way{};       ///< Not yet at their ends.
  FourInts beginning{};    ///< Still at the surface where they began.
  FourInts reached{};      ///< At another surface.
  FourInts passed{};       ///< Beyond it.

  /// Puts a ray into place `k`.
  void start(int k, const Ray& ray) {
    const Eigen::Vector3f way = ray.to - ray.from;
    length[k] = way.norm();
    on_way[k] = length[k] > 0.0F ? -1 : 0;
    set(from, k, ray.from);
    set(direction, k, on_way[k] != 0 ? Eigen::Vector3f(way / length[k]) : way);
    t[k] = 0.0F;
    beginning[k] = -1;
    reached[k] = 0;
    passed[k] = 0;
  }
  [[nodiscard]] Encounter met(int k) const {
    if (passed[k] != 0) return Encounter::kPassed;
    return reached[k] != 0 ? Encounter::kReached : Encounter::kNone;
  }
  [[nodiscard]] bool all_on_way() const {
    return (on_way[0] & on_way[1] & on_way[2] & on_way[3]) != 0;
  }
};

/// Moves the rays that are on their way by a step.
template <typename Distances>
void step(const Distances& distances, float voxel, FourRays& rays) {
  // A point of the voxel's centre that is read may lie half a diagonal away, and the surface point
  // of a voxel as far from the surface.
  const float slack = 0.87F * voxel;
  const FourFloats shortest = FourFloats{} + 0.5F * voxel;
  const FourFloats distance = distances.at_points(rays.from.x + rays.t * rays.direction.x,
                                                  rays.from.y + rays.t * rays.direction.y,
                                                  rays.from.z + rays.t * rays.direction.z);
  const FourInts touches = distance < 0.75F * voxel;
  rays.passed |= rays.on_way & rays.reached & ~touches;
  rays.reached = (rays.on_way & touches & ~rays.beginning) | (~rays.on_way & rays.reached);
  rays.beginning &= touches;
  const FourFloats safe = distance - slack;
  rays.t += safe > shortest ? safe : shortest;
  rays.on_way &= ~rays.passed & (rays.t < rays.length);
}

/// Rays that wait for one of four places, and what those before them have met.
class RayQueue {
 public:
  explicit RayQueue(std::span<const Ray> rays)
      : rays_(rays), encounters_(rays.size(), Encounter::kNone) {
    in_place_.fill(rays.size());
  }
  /// Puts the next rays into the places of those that are done. False if none are left.
  bool refill(FourRays& four) {
    bool busy = false;
    for (int k = 0; k < 4; ++k) {
      std::size_t& ray = in_place_[static_cast<std::size_t>(k)];
      if (four.on_way[k] == 0) {
        if (ray < rays_.size()) encounters_[ray] = four.met(k);
        ray = next_ < rays_.size() ? next_++ : rays_.size();
        if (ray < rays_.size()) four.start(k, rays_[ray]);
      }
      busy = busy || ray < rays_.size();
    }
    return busy;
  }
  [[nodiscard]] std::vector<Encounter> take_encounters() { return std::move(encounters_); }

 private:
  std::span<const Ray> rays_;
  std::vector<Encounter> encounters_;
  std::array<std::size_t, 4> in_place_{};  ///< Numbers of rays; the number of all rays: none.
  std::size_t next_ = 0;
};

/// Traces rays four at a time.
template <typename Distances>
std::vector<Encounter> trace(const Distances& distances, std::span<const Ray> rays) {
  const auto voxel = static_cast<float>(distances.resolution());
  RayQueue queue(rays);
  for (FourRays four; queue.refill(four);) {
    do {
      step(distances, voxel, four);
    } while (four.all_on_way());
  }
  return queue.take_encounters();
}

/// Appends the rays beside a ray.
void append_sides(const Ray& ray, float away, std::vector<Ray>& sides) {
  const Eigen::Vector3f direction = (ray.to - ray.from).normalized();
  const Eigen::Vector3f left = away * direction.unitOrthogonal();
  const Eigen::Vector3f up = direction.cross(left);
  for (const Eigen::Vector3f& side : {left, Eigen::Vector3f(-left), up, Eigen::Vector3f(-up)}) {
    sides.push_back({ray.from + side, ray.to + side});
  }
}

}  // namespace

std::vector<Encounter> encounters(const VoxelDistances& distances, std::span<const Ray> rays) {
  return trace(distances, rays);
}

std::vector<Encounter> encounters(const SurfaceField& surfaces, std::span<const Ray> rays) {
  return trace(surfaces, rays);
}

std::vector<std::size_t> passing_through(const VoxelDistances& distances,
                                         std::span<const Ray> rays) {
  constexpr std::ptrdiff_t kSides = 4;
  const std::vector<Encounter> met = encounters(distances, rays);
  std::vector<std::size_t> candidates;
  std::vector<Ray> sides;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (met[i] != Encounter::kPassed) continue;
    candidates.push_back(i);
    append_sides(rays[i], static_cast<float>(distances.resolution()), sides);
  }
  const std::vector<Encounter> beside = encounters(distances, sides);
  const std::ptrdiff_t wanted = distances.rough() ? kSides - 1 : kSides;
  std::vector<std::size_t> passing;
  for (auto first = beside.begin(); const std::size_t i : candidates) {
    if (std::count(first, first + kSides, Encounter::kPassed) >= wanted) passing.push_back(i);
    first += kSides;
  }
  return passing;
}

}  // namespace castaway::localization
