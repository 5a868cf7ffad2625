/// Many bounding boxes, and which of them a ray may meet.
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

/// A tree of boxes with four children a node, split where the surface area heuristic is least. Its
/// boxes are held in single precision and a little too wide (a millionth of the world's size), so
/// that four of them are tested at once and none is missed.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Eigen::AlignedBox3d> boxes);

  /// The boxes' indices in the order in which `walk` names them.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls `visit(i)` for the places i of `order` whose boxes the ray may meet within `nearest`
  /// [m], the near ones first. `visit` returns how far [m] still matters.
  template <typename Visit>
  void walk(const Ray& ray, double nearest, Visit visit) const;

 private:
  static constexpr int kWidth = 4;
  static constexpr std::uint32_t kLeaf = 1U << 31U;
  // Three more than are taken off with each level, and a side of a split has an eighth or more of
  // its boxes: enough for billions.
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
  /// Children; where there are fewer than four, boxes turned inside out, which no ray meets.
  struct Node {
    std::array<Lanes, 6> faces;               ///< x min, x max, y min, ... z max. [m]
    std::array<std::uint32_t, kWidth> child;  ///< A node or, with `kLeaf`, a place in `order`.
  };
  /// What is still to be looked at. Arrays, since a compiler copies a struct of them in pieces
  /// that the processor must wait for.
  struct Stack {
    std::array<float, kStackSize> enter;  ///< [m] Not initialised: that would take its time.
    std::array<std::uint32_t, kStackSize> child;
    std::size_t depth = 0;
  };
  /// A ray prepared for many boxes.
  struct Probe {
    explicit Probe(const Ray& ray);

    std::array<float, 3> origin;
    std::array<float, 3> inverse;       ///< Of the direction.
    std::array<std::size_t, 3> near{};  ///< Face of each axis that the ray meets first.
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

  double reach_ = 0.0;  ///< [m] Beyond it, single precision is not enough.
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

inline BoxTree::Probe::Probe(const Ray& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const auto d = static_cast<float>(ray.direction[axis]);
    origin[a] = static_cast<float>(ray.origin[axis]);
    inverse[a] = 1.0F / (std::abs(d) < 1e-30F ? 1e-30F : d);  // Never 0 times infinity.
    near[a] = 2 * a + (inverse[a] < 0.0F ? 1 : 0);
  }
}

inline float BoxTree::limit_of(double nearest) {
  return static_cast<float>(std::min(nearest, 1e30)) * 1.000001F;
}

/// Puts the children that the ray may meet onto the stack, the nearest on top.
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
