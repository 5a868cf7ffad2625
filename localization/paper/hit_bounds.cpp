#include "localization/paper/hit_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace castaway::localization {
namespace {

constexpr int kPerHit = 255;
// Sums of this many bytes fit 16 bits.
constexpr std::size_t kBlock = 257;

int bound_at(const RayLocalModel& model, int distance) {
  return static_cast<int>(std::ceil(kPerHit * model.hits_at(static_cast<std::size_t>(distance))));
}

/// Adds the bytes at the end points to the sums of a run, which begins at `base` in a padded row
/// of `columns` bytes.
void add_bytes(const std::uint8_t* row, int base, int columns, std::vector<std::uint16_t>& sums) {
  const int first = std::max(0, -base);
  const int end = std::min(static_cast<int>(sums.size()), columns - base);
  for (int c = first; c < end; ++c) {
    std::uint16_t& sum = sums[static_cast<std::size_t>(c)];
    sum = static_cast<std::uint16_t>(sum + row[base + c]);
  }
}

}  // namespace

HitBounds::HitBounds(const RayLocalModel& model)
    : padding_(model.walls().cap()),
      columns_(model.frame().width + 2 * padding_),
      rows_(model.frame().height + 2 * padding_),
      far_(bound_at(model, padding_)) {
  bytes_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const int distance = model.walls().at(column - padding_, row - padding_);
      bytes_.push_back(static_cast<std::uint8_t>(bound_at(model, distance) - far_));
    }
  }
}

std::int64_t HitBounds::least(double quality, std::size_t beams) const {
  const double hits = quality * static_cast<double>(beams);
  // Less one, for the rounding errors of a sum of hits.
  return static_cast<std::int64_t>(std::floor(kPerHit * hits)) - 1 -
         static_cast<std::int64_t>(beams) * far_;
}

std::int64_t HitBounds::at(const std::vector<CellOffset>& ends, const Eigen::Vector2i& cell) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const auto rows = static_cast<std::size_t>(rows_);
  std::int64_t sum = 0;
  for (const CellOffset& end : ends) {
    const auto column = static_cast<std::size_t>(cell.x() + end.dx + padding_);  // Huge if < 0.
    const auto row = static_cast<std::size_t>(cell.y() + end.dy + padding_);
    if (column < columns && row < rows) sum += bytes_[row * columns + column];
  }
  return sum;
}

std::vector<std::uint32_t> HitBounds::in_run(const std::vector<CellOffset>& ends,
                                             const CellRun& run) const {
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(run.end - run.first));
  std::vector<std::uint16_t> block(sums.size());
  for (std::size_t first = 0; first < ends.size(); first += kBlock) {
    std::fill(block.begin(), block.end(), std::uint16_t{0});
    for (std::size_t i = first; i < std::min(first + kBlock, ends.size()); ++i) {
      const int row = run.row + ends[i].dy + padding_;
      if (row < 0 || row >= rows_) continue;
      const std::uint8_t* bytes = bytes_.data() + std::ptrdiff_t{row} * columns_;
      add_bytes(bytes, run.first + ends[i].dx + padding_, columns_, block);
    }
    std::transform(sums.begin(), sums.end(), block.begin(), sums.begin(), std::plus<>());
  }
  return sums;
}

}  // namespace castaway::localization
