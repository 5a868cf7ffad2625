#include "tools/twin/alignment/wall_offsets.hpp"

namespace castaway::testbed {

WallOffsets::WallOffsets(const localization::GridFrame& frame, double usual)
    : usual_(usual), sums_(frame.size()), counts_(frame.size()) {}

void WallOffsets::add(std::size_t cell, double offset) {
  sums_[cell] += static_cast<float>(offset);
  counts_[cell] += 1.0F;
}

double WallOffsets::at(std::size_t cell) const {
  constexpr double kPrior = 20.0;  // Measurements that count as much as the usual offset.
  return (sums_[cell] + kPrior * usual_) / (counts_[cell] + kPrior);
}

}  // namespace castaway::testbed
