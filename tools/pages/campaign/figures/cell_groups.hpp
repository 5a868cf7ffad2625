/// Cells that differ by their localizers alone.
#pragma once

#include <vector>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// All cells that have a row, in groups with the same sample and the same values of all keys but
/// `localizers`. Calls `take` with the cells of each, sample after sample.
template <typename Take>
void each_cell_group(const CampaignSpec& spec, const CellRows& rows, Take take);

/// Where the key `localizers` stands in the grid.
struct LocalizerStride {
  int values = 1;  ///< How many values it has; 1 if it does not vary.
  int below = 1;   ///< Combinations of the keys after it.
};

LocalizerStride localizer_stride(const CampaignSpec& spec);

template <typename Take>
void each_cell_group(const CampaignSpec& spec, const CellRows& rows, Take take) {
  const LocalizerStride stride = localizer_stride(spec);
  for (int s = 0; s < spec.samples(); ++s) {
    for (int k = 0; k < spec.combinations(); ++k) {
      if (k / stride.below % stride.values != 0) continue;  // Not the first value of `localizers`.
      std::vector<int> cells;
      for (int v = 0; v < stride.values; ++v) {
        const int cell = (k + v * stride.below) * spec.samples() + s;
        if (rows.has(cell)) cells.push_back(cell);
      }
      if (!cells.empty()) take(cells);
    }
  }
}

}  // namespace castaway::testbed
