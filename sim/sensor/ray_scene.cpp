#include "sim/sensor/ray_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace castaway::sim {
namespace {

constexpr std::size_t kLeafSize = 2;
constexpr double kPadding = 1e-9;  // [m] A ray in the very face of a bounding box meets it.
constexpr int kNobody = -1;
// Each side of a split has an eighth of its shapes or more: enough for 25 million.
constexpr std::size_t kStackSize = 128;

Eigen::AlignedBox3d padded(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kPadding);
  return {box.min() - margin, box.max() + margin};
}

double surface(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

/// 1 / d with zeros replaced, so that slabs never multiply 0 with infinity.
Eigen::Vector3d safe_inverse(const Eigen::Vector3d& d) {
  return d.unaryExpr([](double x) { return 1.0 / (std::abs(x) < 1e-30 ? 1e-30 : x); });
}

}  // namespace

/// A ray prepared for many box tests.
struct RayScene::RayWalk {
  explicit RayWalk(const Ray& ray) : origin(ray.origin), inverse(safe_inverse(ray.direction)) {}

  [[nodiscard]] bool meets(const Node& node, double nearest) const {
    const Eigen::Array3d t1 = (node.min - origin).array() * inverse.array();
    const Eigen::Array3d t2 = (node.max - origin).array() * inverse.array();
    const Eigen::Array3d enter = t1.min(t2);
    const Eigen::Array3d leave = t1.max(t2);
    return std::max({enter[0], enter[1], enter[2], 0.0}) <=
           std::min({leave[0], leave[1], leave[2], nearest});
  }

  Eigen::Vector3d origin;
  Eigen::Vector3d inverse;
};

RayScene::RayScene(std::vector<RayPrimitive> primitives) : primitives_(std::move(primitives)) {
  std::vector<Item> items(primitives_.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i] = {padded(bounds(primitives_[i])), static_cast<std::uint32_t>(i)};
  }
  nodes_.reserve(2 * items.size());
  if (!items.empty()) build(items, 0, items.size());
  std::vector<RayPrimitive> ordered;
  ordered.reserve(items.size());
  for (const Item& item : items) ordered.push_back(primitives_[item.primitive]);
  primitives_ = std::move(ordered);
}

void RayScene::build(std::vector<Item>& items, std::size_t first, std::size_t last) {
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox3d centers;
  for (std::size_t i = first; i < last; ++i) {
    box.extend(items[i].box);
    centers.extend(Eigen::Vector3d(items[i].box.center()));
  }
  const std::size_t index = nodes_.size();
  nodes_.push_back({box.min(), box.max(), static_cast<std::uint32_t>(first),
                    static_cast<std::uint32_t>(last - first), 0});
  if (last - first <= kLeafSize) return;
  int axis = 0;
  centers.sizes().maxCoeff(&axis);
  const std::size_t middle = split(items, first, last, axis);
  nodes_[index].count = 0;
  nodes_[index].axis = axis;
  build(items, first, middle);
  nodes_[index].second = static_cast<std::uint32_t>(nodes_.size());
  build(items, middle, last);
}

/// Sorts along `axis` and finds the least sum of surface times count.
std::size_t RayScene::split(std::vector<Item>& items, std::size_t first, std::size_t last,
                            int axis) {
  const auto begin = items.begin();
  std::sort(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
            [axis](const Item& a, const Item& b) {
              const double x_a = a.box.center()[axis];
              const double x_b = b.box.center()[axis];
              return x_a != x_b ? x_a < x_b : a.primitive < b.primitive;
            });
  std::vector<double> cost(last - first, 0.0);  // cost[k]: the first k items on one side.
  Eigen::AlignedBox3d left;
  Eigen::AlignedBox3d right;
  for (std::size_t k = 1; k < cost.size(); ++k) {
    left.extend(items[first + k - 1].box);
    cost[k] += surface(left) * static_cast<double>(k);
    right.extend(items[last - k].box);
    cost[cost.size() - k] += surface(right) * static_cast<double>(k);
  }
  const auto least = static_cast<std::ptrdiff_t>(std::max<std::size_t>(cost.size() / 8, 1));
  return first + static_cast<std::size_t>(
                     std::min_element(cost.begin() + least, cost.end() - least + 1) - cost.begin());
}

void RayScene::visit_leaf(const Node& node, const Ray& ray, RayHit& nearest) const {
  for (std::uint32_t i = node.second; i < node.second + node.count; ++i) {
    const double distance = intersect(primitives_[i], ray);
    if (distance < nearest.distance) nearest = {distance, primitives_[i].object, i};
  }
}

std::optional<RayHit> RayScene::cast(const Ray& ray, double max_distance,
                                     std::uint32_t guess) const {
  const RayWalk walk(ray);
  RayHit nearest{max_distance, kNobody, kNoPrimitive};
  if (guess < primitives_.size()) {
    const double distance = intersect(primitives_[guess], ray);
    if (distance < max_distance) nearest = {distance, primitives_[guess].object, guess};
  }
  std::array<std::uint32_t, kStackSize> stack;  // Not initialised: that would take its time.
  std::size_t depth = 0;
  if (!nodes_.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (!walk.meets(node, nearest.distance)) continue;
    if (node.count > 0) {
      visit_leaf(node, ray, nearest);
      continue;
    }
    const bool forward = ray.direction[node.axis] >= 0.0;
    stack[depth++] = forward ? node.second : index + 1;
    stack[depth++] = forward ? index + 1 : node.second;
  }
  if (nearest.object == kNobody) return std::nullopt;
  return nearest;
}

}  // namespace castaway::sim
