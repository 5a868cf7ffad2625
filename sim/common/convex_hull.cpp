#include "sim/common/convex_hull.hpp"

#include <algorithm>

namespace castaway::sim {
namespace {

/// Appends one side of a convex hull, without its last point.
template <typename Iterator>
void append_chain(Iterator begin, Iterator end, std::vector<Eigen::Vector2d>& hull) {
  const std::size_t base = hull.size();
  for (Iterator p = begin; p != end; ++p) {
    while (hull.size() >= base + 2 &&
           cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(*p);
  }
  hull.pop_back();
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  append_chain(points.begin(), points.end(), hull);
  append_chain(points.rbegin(), points.rend(), hull);
  return hull;
}

}  // namespace castaway::sim
