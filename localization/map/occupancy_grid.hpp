/// The free cells of an occupancy grid (castaway/grid.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "castaway/grid.hpp"
#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Draws poses uniformly from the free cells of a map and from all yaws.
class FreeSpace {
 public:
  explicit FreeSpace(const OccupancyGrid& grid);
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  /// Draws a pose of base in map. Requires a space that is not empty.
  [[nodiscard]] SE2 sample(Rng& rng) const;

 private:
  GridFrame frame_;
  std::vector<std::uint32_t> cells_;  ///< Indices of the free cells.
};

}  // namespace castaway::localization
