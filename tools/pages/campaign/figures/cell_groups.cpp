#include "tools/pages/campaign/figures/cell_groups.hpp"

#include "tools/pages/campaign/figures/campaign_series.hpp"

namespace castaway::testbed {

LocalizerStride localizer_stride(const CampaignSpec& spec) {
  LocalizerStride stride;
  for (const GridKey& key : spec.grid) {
    const auto values = static_cast<int>(key.values.size());
    if (key.path == kLocalizersKey) {
      stride = {values, 1};
    } else {
      stride.below *= values;
    }
  }
  return stride;
}

}  // namespace castaway::testbed
