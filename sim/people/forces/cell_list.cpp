#include "sim/people/forces/cell_list.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace castaway::sim {
namespace {

constexpr double kCellsPerPoint = 4.0;

/// Edge of cells that are at least `edge` long and not too many for the area.
double cell_edge(const Eigen::AlignedBox2d& box, double edge, std::size_t points) {
  const double most = kCellsPerPoint * static_cast<double>(points);
  const Eigen::Vector2d sizes = box.sizes();
  return std::max({edge, std::sqrt(sizes.x() * sizes.y() / most), sizes.maxCoeff() / most});
}

/// In lexicographic order: by counting for the first index, by comparing for the few second ones.
IndexPairs sort_pairs(const IndexPairs& pairs, std::size_t points) {
  std::vector<std::size_t> end(points + 1, 0);
  for (const auto& pair : pairs) ++end[pair.first + 1];
  for (std::size_t i = 0; i < points; ++i) end[i + 1] += end[i];
  IndexPairs sorted(pairs.size());
  for (const auto& pair : pairs) sorted[end[pair.first]++] = pair;
  auto begin = sorted.begin();
  for (std::size_t i = 0; i < points; ++i) {
    const auto next = sorted.begin() + static_cast<std::ptrdiff_t>(end[i]);
    std::sort(begin, next);
    begin = next;
  }
  return sorted;
}

}  // namespace

CellList::CellList(const std::vector<Eigen::Vector2d>& points, double edge) {
  Eigen::AlignedBox2d box(Eigen::Vector2d::Zero().eval());
  if (!points.empty()) box = Eigen::AlignedBox2d(points.front());
  for (const Eigen::Vector2d& p : points) box.extend(p);
  const double cell = cell_edge(box, edge, std::max<std::size_t>(points.size(), 1));
  const auto index = [cell](double length) { return static_cast<int>(length / cell); };
  columns_ = index(box.sizes().x()) + 1;
  rows_ = index(box.sizes().y()) + 1;
  std::vector<int> cells;
  begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d offset = p - box.min();
    cells.push_back(index(offset.y()) * columns_ + index(offset.x()));
    ++begin_[static_cast<std::size_t>(cells.back()) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::size_t> next = begin_;
  order_.resize(points.size());
  cell_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t place = next[static_cast<std::size_t>(cells[i])]++;
    order_[place] = i;
    cell_[place] = cells[i];
  }
}

IndexPairs near_pairs(const std::vector<Eigen::Vector2d>& points, double reach) {
  const CellList cells(points, reach);
  const std::vector<std::size_t>& order = cells.order();
  IndexPairs pairs;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t i = order[place];
    cells.visit_later(place, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t j = order[k];
        const bool near = (points[j] - points[i]).squaredNorm() <= reach * reach;
        if (near) pairs.push_back(std::minmax(i, j));
      }
    });
  }
  return sort_pairs(pairs, points.size());
}

}  // namespace castaway::sim
