/// Exact ray casts into moving bodies.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/casting/ray_scene.hpp"
#include "sim/casting/ray_shapes.hpp"

namespace castaway::sim {

/// A solid with the same elliptic horizontal cut from `bottom` to `top`. In map.
struct UprightPart {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();     ///< [m]
  Eigen::Vector2d axis_x = Eigen::Vector2d::UnitX();    ///< Unit vector of `half_size.x()`.
  Eigen::Vector2d half_size = Eigen::Vector2d::Ones();  ///< [m] Semi-axes; equal for a circle.
  double bottom = 0.0;                                  ///< [m] Above the floor.
  double top = 1.0;                                     ///< [m]
};

/// Distance along a ray in map to where it enters the part, kNoHit if it does not; 0 if it starts
/// inside. Exact: the ellipse is scaled to a circle, which keeps distances along the ray.
double intersect(const UprightPart& part, const Ray& ray);

/// A body with a few parts, such as a person.
struct MovingBody {
  static constexpr std::size_t kMaxParts = 4;

  int object = 0;  ///< Label returned with hits.
  std::array<UprightPart, kMaxParts> parts;
  std::size_t count = 0;  ///< Number of parts in use.
};

/// Bodies that move at every update, for which a tree would be outdated at once. A ray is tested
/// against the discs around sixteen bodies at a time, in single precision with a margin, and then
/// in double precision against the parts of the remaining ones. Results equal those of a loop over
/// all parts.
class MovingScene {
 public:
  MovingScene() = default;
  explicit MovingScene(std::vector<MovingBody> bodies);

  /// The nearest hit within `max_distance` [m]; nothing if there is none. Linear in the bodies.
  [[nodiscard]] std::optional<RayHit> cast(const Ray& ray, double max_distance) const;
  [[nodiscard]] const std::vector<MovingBody>& bodies() const { return bodies_; }

 private:
  static constexpr std::size_t kWidth = 16;
  using Lanes = Eigen::Array<float, kWidth, 1>;

  /// Discs around bodies, seen from above. An unused one has a negative radius.
  struct Discs {
    Lanes x;       ///< [m]
    Lanes y;       ///< [m]
    Lanes radius;  ///< [m]
  };
  struct Walk;

  static void visit(const MovingBody& body, const Ray& ray, RayHit& nearest);

  std::vector<MovingBody> bodies_;
  std::vector<Discs> discs_;
};

}  // namespace castaway::sim
