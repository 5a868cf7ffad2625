#include "localization/matching/scan_shifts.hpp"

#include <algorithm>
#include <numeric>

namespace castaway::localization {
namespace {

/// A step through `size` items that visits each once and neighbours far apart: coprime, near the
/// golden section.
std::size_t mixing_step(std::size_t size) {
  auto step = static_cast<std::size_t>(0.618 * static_cast<double>(size));
  while (step > 1 && std::gcd(step, size) != 1) --step;
  return std::max<std::size_t>(step, 1);
}

}  // namespace

ScanShifts::ScanShifts(std::size_t levels, const std::vector<std::vector<CellOffset>>& scans)
    : first_{0}, known_(levels * scans.size()) {
  for (const auto& scan : scans) first_.push_back(first_.back() + scan.size());
  offsets_.reserve(first_.back());
  for (const auto& scan : scans) {
    const std::size_t step = mixing_step(scan.size());
    std::size_t from = 0;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      offsets_.push_back(scan[from]);
      from = (from + step) % scan.size();
    }
  }
  shifts_.resize(levels * offsets_.size());
}

void ScanShifts::compute(const PooledLayout& layout, std::size_t first,
                         std::span<std::int32_t> shifts) const {
  const PooledLayout local = layout;  // Not aliased by the shifts, so that the loop is vectorised.
  const CellOffset* offset = offsets_.data() + first;
  for (std::int32_t& shift : shifts) {
    shift = local.shift(offset->dx, offset->dy);
    ++offset;
  }
}

}  // namespace castaway::localization
