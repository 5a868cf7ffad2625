/// End points of a scan as offsets into the bytes of pooled fields.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "localization/map/pooled_field.hpp"
#include "localization/matching/search_space.hpp"

namespace castaway::localization {

/// A scan's end points at every yaw of a search, as byte offsets on every level. Those of a level
/// and yaw are computed at their first use: many searches need few of them.
class ScanShifts {
 public:
  /// `scans[i]` is the scan rotated by yaw i. The shifts of a yaw are in a mixed order, so that the
  /// first ones are spread over the scan.
  ScanShifts(std::size_t levels, const std::vector<std::vector<CellOffset>>& scans);

  /// Shifts at a yaw on a level with this layout; always the same layout for a level.
  std::span<const std::int32_t> at(const PooledLayout& layout, std::size_t yaw) {
    const auto level = static_cast<std::size_t>(layout.level);
    const std::size_t i = level * (first_.size() - 1) + yaw;
    const std::span<std::int32_t> shifts = std::span(shifts_).subspan(
        level * offsets_.size() + first_[yaw], first_[yaw + 1] - first_[yaw]);
    if (!known_[i]) {
      known_[i] = 1;
      compute(layout, first_[yaw], shifts);
    }
    return shifts;
  }

 private:
  void compute(const PooledLayout& layout, std::size_t first, std::span<std::int32_t> shifts) const;

  std::vector<std::size_t> first_;    ///< Index of the first point of every yaw, and the end.
  std::vector<CellOffset> offsets_;   ///< Of the points of all yaws.
  std::vector<std::int32_t> shifts_;  ///< Those of `offsets_`, level by level.
  std::vector<std::uint8_t> known_;   ///< For each yaw, level by level: the shifts are computed.
};

}  // namespace castaway::localization
