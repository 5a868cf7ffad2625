#include "sim/casting/box_tree.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "sim/common/random.hpp"
#include "tests/sim/support/random_rays.hpp"

namespace castaway::sim {
namespace {

using Boxes = std::vector<Eigen::AlignedBox3d>;

Boxes random_boxes(int count, double reach, Rng& rng) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d half = random_point(0.02 * reach, rng).cwiseAbs();
    const Eigen::Vector3d center = random_point(reach, rng);
    boxes.emplace_back(Eigen::Vector3d(center - half), Eigen::Vector3d(center + half));
  }
  return boxes;
}

/// Distance at which a ray enters a box, in double precision; infinity if it misses.
double entry(const Eigen::AlignedBox3d& box, const Ray& ray) {
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double t1 = (box.min()[axis] - ray.origin[axis]) / ray.direction[axis];
    const double t2 = (box.max()[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

std::set<std::uint32_t> visited(const BoxTree& tree, const Ray& ray, double nearest) {
  std::set<std::uint32_t> result;
  tree.walk(ray, nearest, [&](std::uint32_t i) {
    result.insert(tree.order()[i]);
    return nearest;
  });
  return result;
}

/// The first box within `nearest` that the ray meets but the tree does not visit; -1 if there is
/// none.
int missed(const Boxes& boxes, const BoxTree& tree, const Ray& ray, double nearest) {
  const std::set<std::uint32_t> seen = visited(tree, ray, nearest);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (entry(boxes[i], ray) <= nearest && !seen.contains(i)) return static_cast<int>(i);
  }
  return -1;
}

TEST(BoxTree, MissesNoBox) {
  Rng rng(3);
  for (const double reach : {1.0, 30.0, 5e3, 1e6}) {
    for (const int count : {1, 2, 3, 9, 400}) {
      const Boxes boxes = random_boxes(count, reach, rng);
      const BoxTree tree(boxes);
      for (int i = 0; i < 1000; ++i) {
        const Ray ray{random_point(1.5 * reach, rng), random_direction(rng)};
        ASSERT_EQ(missed(boxes, tree, ray, reach), -1) << reach << " m, " << count << " boxes";
      }
    }
  }
}

TEST(BoxTree, MissesNoBoxAlongAnAxisOrInAFace) {
  const Boxes boxes{{Eigen::Vector3d(1.0, -1.0, 0.0), Eigen::Vector3d(2.0, 1.0, 1.0)},
                    {Eigen::Vector3d(3.0, 1.0, 1.0), Eigen::Vector3d(3.0, 2.0, 2.0)},
                    {Eigen::Vector3d(-9.0, 0.0, 0.0), Eigen::Vector3d(-8.0, 1.0, 1.0)}};
  const BoxTree tree(boxes);
  const auto ahead = visited(tree, {{0.0, 1.0, 1.0}, Eigen::Vector3d::UnitX()}, 100.0);
  EXPECT_TRUE(ahead.contains(0));
  EXPECT_TRUE(ahead.contains(1));
  EXPECT_TRUE(visited(tree, {{1.5, 0.0, 5.0}, -Eigen::Vector3d::UnitZ()}, 100.0).contains(0));
  EXPECT_TRUE(visited(tree, {{0.0, 0.5, 0.5}, -Eigen::Vector3d::UnitX()}, 100.0).contains(2));
}

TEST(BoxTree, VisitsFewOfMany) {
  Rng rng(5);
  const Boxes boxes = random_boxes(1000, 30.0, rng);
  const BoxTree tree(boxes);
  std::size_t count = 0;
  for (int i = 0; i < 200; ++i) {
    count += visited(tree, {random_point(30.0, rng), random_direction(rng)}, 30.0).size();
  }
  EXPECT_LT(count, 200U * 30U);
}

TEST(BoxTree, StopsWhereNothingFurtherMatters) {
  Boxes boxes;
  for (int i = 0; i < 100; ++i) {
    boxes.emplace_back(Eigen::Vector3d(i + 1.0, -0.1, -0.1), Eigen::Vector3d(i + 1.2, 0.1, 0.1));
  }
  const BoxTree tree(boxes);
  int count = 0;
  tree.walk({Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 1e9, [&](std::uint32_t i) {
    ++count;
    return entry(boxes[tree.order()[i]], {});
  });
  EXPECT_LT(count, 5);
}

TEST(BoxTree, VisitsAllFromFarOff) {
  Rng rng(7);
  const BoxTree tree(random_boxes(50, 10.0, rng));
  const auto seen = visited(tree, {{1e9, 0.0, 0.0}, Eigen::Vector3d::UnitX()}, 1.0);
  EXPECT_EQ(seen.size(), 50U);
}

TEST(BoxTree, MayBeEmpty) {
  const BoxTree tree(Boxes{});
  EXPECT_TRUE(visited(tree, {}, 10.0).empty());
}

}  // namespace
}  // namespace castaway::sim
