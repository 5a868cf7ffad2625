#include "tools/twin/alignment/seen_cells.hpp"

#include <cmath>
#include <limits>

namespace castaway::testbed {
namespace {

void count_up(std::uint16_t& count) {
  if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
}

}  // namespace

SeenCells::SeenCells(const localization::GridFrame& frame)
    : frame_(frame), returns_(frame.size()), passes_(frame.size()), counted_(frame.size()) {}

std::optional<std::size_t> SeenCells::index_of(const Eigen::Vector2d& p) const {
  const Eigen::Vector2i cell(static_cast<int>(std::floor(p.x())),
                             static_cast<int>(std::floor(p.y())));
  if (!frame_.contains(cell)) return std::nullopt;
  return frame_.index(cell);
}

void SeenCells::mark(const Eigen::Vector2d& p_cells, bool returns) {
  const auto index = index_of(p_cells);
  const std::uint32_t now = 2 * scan_ + (returns ? 1 : 0);
  if (!index || counted_[*index] >= now) return;
  counted_[*index] = now;
  count_up(returns ? returns_[*index] : passes_[*index]);
}

void SeenCells::add_scan(const std::vector<Beam>& beams, double before) {
  constexpr double kStep = 0.7;  // cells
  begin_scan();
  for (const Beam& beam : beams) {
    if (beam.returns) mark(beam.end, true);
  }
  for (const Beam& beam : beams) {
    const Eigen::Vector2d way = beam.end - beam.from;
    const double length = way.norm();
    for (double t = 0.0; t < length - before; t += kStep) {
      mark(beam.from + (t / length) * way, false);
    }
  }
}

int SeenCells::returns(const Eigen::Vector2d& p_cells) const {
  const auto index = index_of(p_cells);
  return index ? returns_[*index] : 0;
}

int SeenCells::passes(const Eigen::Vector2d& p_cells) const {
  const auto index = index_of(p_cells);
  return index ? passes_[*index] : 0;
}

}  // namespace castaway::testbed
