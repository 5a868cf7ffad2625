#include "sim/casting/box_tree.hpp"

#include <limits>

namespace castaway::sim {
namespace {

constexpr double kPrecision = 1e-6;  // Relative to `reach_`; more than single precision loses.
constexpr double kLeastReach = 1e3;  // [m]
constexpr float kNothing = 1e30F;

double surface(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

Eigen::AlignedBox3d widen(const Eigen::AlignedBox3d& box, double margin) {
  const Eigen::Vector3d all = Eigen::Vector3d::Constant(margin);
  return {box.min() - all, box.max() + all};
}

}  // namespace

BoxTree::BoxTree(std::span<const Eigen::AlignedBox3d> boxes) : reach_(kLeastReach) {
  for (const Eigen::AlignedBox3d& box : boxes) {
    reach_ = std::max({reach_, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
  }
  std::vector<Item> items;
  for (const Eigen::AlignedBox3d& box : boxes) {
    items.push_back({widen(box, kPrecision * reach_), static_cast<std::uint32_t>(items.size())});
  }
  if (!items.empty()) build(items, run_of(items, 0, items.size()));
  for (const Item& item : items) order_.push_back(item.index);
}

BoxTree::Run BoxTree::run_of(std::span<const Item> items, std::size_t first, std::size_t last) {
  Run run{first, last, {}};
  for (const Item& item : items.subspan(first, last - first)) run.box.extend(item.box);
  return run;
}

/// Sorts a run along its longest axis and returns the split with the least surface area heuristic.
std::size_t BoxTree::split(std::span<Item> items, const Run& run) {
  const std::span<Item> part = items.subspan(run.first, run.last - run.first);
  Eigen::AlignedBox3d centers;
  for (const Item& item : part) centers.extend(Eigen::Vector3d(item.box.center()));
  int axis = 0;
  centers.sizes().maxCoeff(&axis);
  std::sort(part.begin(), part.end(), [axis](const Item& a, const Item& b) {
    const double x_a = a.box.center()[axis];
    const double x_b = b.box.center()[axis];
    return x_a != x_b ? x_a < x_b : a.index < b.index;
  });
  std::vector<double> cost(part.size(), 0.0);  // cost[k] has the first k items on one side.
  Eigen::AlignedBox3d left;
  Eigen::AlignedBox3d right;
  for (std::size_t k = 1; k < cost.size(); ++k) {
    left.extend(part[k - 1].box);
    cost[k] += surface(left) * static_cast<double>(k);
    right.extend(part[part.size() - k].box);
    cost[cost.size() - k] += surface(right) * static_cast<double>(k);
  }
  const auto least = static_cast<std::ptrdiff_t>(std::max<std::size_t>(cost.size() / 8, 1));
  const auto best = std::min_element(cost.begin() + least, cost.end() - least + 1);
  return run.first + static_cast<std::size_t>(best - cost.begin());
}

/// Splits a run into up to four, the one with the largest box first.
std::vector<BoxTree::Run> BoxTree::children(std::span<Item> items, const Run& whole) {
  std::vector<Run> runs{whole};
  while (runs.size() < kWidth) {
    auto largest = runs.end();
    for (auto run = runs.begin(); run != runs.end(); ++run) {
      if (run->last - run->first == 1) continue;
      if (largest == runs.end() || surface(run->box) > surface(largest->box)) largest = run;
    }
    if (largest == runs.end()) break;
    const Run run = *largest;
    const std::size_t middle = split(items, run);
    *largest = run_of(items, run.first, middle);
    runs.push_back(run_of(items, middle, run.last));
  }
  return runs;
}

std::uint32_t BoxTree::build(std::span<Item> items, const Run& whole) {
  const std::vector<Run> runs = children(items, whole);
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  for (int face = 0; face < 6; ++face) {
    nodes_[index].faces[static_cast<std::size_t>(face)].setConstant(face % 2 == 0 ? kNothing
                                                                                  : -kNothing);
  }
  for (std::size_t lane = 0; lane < runs.size(); ++lane) {
    const Run& run = runs[lane];
    for (int axis = 0; axis < 3; ++axis) {
      const auto low = 2 * static_cast<std::size_t>(axis);
      const auto i = static_cast<Eigen::Index>(lane);
      nodes_[index].faces[low][i] = static_cast<float>(run.box.min()[axis]);
      nodes_[index].faces[low + 1][i] = static_cast<float>(run.box.max()[axis]);
    }
    const bool leaf = run.last - run.first == 1;
    const auto first = static_cast<std::uint32_t>(run.first);
    const std::uint32_t child = leaf ? first | kLeaf : build(items, run);
    nodes_[index].child[lane] = child;
  }
  return index;
}

}  // namespace castaway::sim
