/// A bounding volume hierarchy: finds the boxes that a ray may hit.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/casting/ray_shapes.hpp"

namespace castaway::sim {

/// A tree of boxes with four children per node, split by the surface area heuristic. Its boxes are
/// stored in single precision and slightly enlarged (by a millionth of the world's size), so that
/// four of them are tested at once and no hit is missed.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Eigen::AlignedBox3d> boxes);

  /// Indices of the boxes, in the order in which `walk` refers to them.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls `visit(i)` for the positions i in `order` whose boxes the ray may hit within `nearest`
  /// [m], near ones first. `visit` returns the distance [m] beyond which hits no longer matter.
  template <typename Visit>
  void walk(const Ray& ray, double nearest, Visit visit) const;

 private:
  static constexpr int kWidth = 4;
  static constexpr std::uint32_t kLeaf = 1U << 31U;
  // Each level pushes up to three more children than it pops, and each side of a split has at least
  // an eighth of its boxes: enough for billions.
  static constexpr std::size_t kStackSize = 512;
  using Lanes = Eigen::Array<float, kWidth, 1>;

  struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
    Eigen::AlignedBox3d box;
  };
  struct Item {
    Eigen::AlignedBox3d box;
    std::uint32_t index = 0;
  };
  /// Children; unused ones have inverted boxes, which no ray hits.
  struct Node {
    std::array<Lanes, 6> faces;  ///< x min, x max, y min, ... z max. [m]
    /// Index of a node or, with `kLeaf`, a position in `order`.
    std::array<std::uint32_t, kWidth> child;
  };
  /// Nodes still to visit. Separate arrays, since compilers copy an array of structs in pieces that
  /// the processor must wait for.
  struct Stack {
    std::array<float, kStackSize> enter;  ///< [m] Not initialised, to save time.
    std::array<std::uint32_t, kStackSize> child;
    std::size_t depth = 0;
  };
  /// A ray prepared for many box tests.
  struct Probe {
    explicit Probe(const Ray& ray);

    std::array<float, 3> origin;
    std::array<float, 3> inverse;       ///< Inverse of the direction.
    std::array<std::size_t, 3> near{};  ///< For each axis, the face that the ray hits first.
  };

  static Run run_of(std::span<const Item> items, std::size_t first, std::size_t last);
  static std::size_t split(std::span<Item> items, const Run& run);
  static std::vector<Run> children(std::span<Item> items, const Run& whole);
  std::uint32_t build(std::span<Item> items, const Run& whole);
  [[nodiscard]] static float limit_of(double nearest);
  static void push(const Node& node, const Probe& probe, float limit, Stack& stack);
  [[nodiscard]] bool is_far(const Eigen::Vector3d& origin) const {
    return !(origin.cwiseAbs().maxCoeff() <= reach_);
  }

  double reach_ = 0.0;  ///< [m] Single precision is not enough for rays from beyond it.
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

inline BoxTree::Probe::Probe(const Ray& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto d = static_cast<float>(ray.direction[axis]);
    origin[a] = static_cast<float>(ray.origin[axis]);
    inverse[a] = 1.0F / (std::abs(d) < 1e-30F ? 1e-30F : d);  // Avoids 0 times infinity.
    near[a] = 2 * a + (inverse[a] < 0.0F ? 1 : 0);
  }
}

inline float BoxTree::limit_of(double nearest) {
  return static_cast<float>(std::min(nearest, 1e30)) * 1.000001F;
}

/// Pushes the children that the ray may hit, the nearest on top.
inline void BoxTree::push(const Node& node, const Probe& probe, float limit, Stack& stack) {
  Lanes enter = Lanes::Zero();
  Lanes leave = Lanes::Constant(limit);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t near = probe.near[axis];
    enter = enter.max((node.faces[near] - probe.origin[axis]) * probe.inverse[axis]);
    leave = leave.min((node.faces[near ^ 1U] - probe.origin[axis]) * probe.inverse[axis]);
  }
  const std::size_t bottom = stack.depth;
  for (std::size_t lane = 0; lane < kWidth; ++lane) {
    const float from = enter[static_cast<Eigen::Index>(lane)];
    if (!(from <= leave[static_cast<Eigen::Index>(lane)])) continue;
    std::size_t at = stack.depth++;
    for (; at > bottom && stack.enter[at - 1] < from; --at) {
      stack.enter[at] = stack.enter[at - 1];
      stack.child[at] = stack.child[at - 1];
    }
    stack.enter[at] = from;
    stack.child[at] = node.child[lane];
  }
}

template <typename Visit>
void BoxTree::walk(const Ray& ray, double nearest, Visit visit) const {
  if (nodes_.empty()) return;
  if (is_far(ray.origin)) {
    for (std::uint32_t i = 0; i < order_.size(); ++i) visit(i);
    return;
  }
  const Probe probe(ray);
  float limit = limit_of(nearest);
  Stack stack;
  push(nodes_.front(), probe, limit, stack);
  while (stack.depth > 0) {
    const std::size_t top = --stack.depth;
    if (stack.enter[top] > limit) continue;
    const std::uint32_t child = stack.child[top];
    if ((child & kLeaf) == 0) {
      push(nodes_[child], probe, limit, stack);
    } else {
      limit = limit_of(visit(child & ~kLeaf));
    }
  }
}

}  // namespace castaway::sim
