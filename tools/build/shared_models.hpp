/// Models of localizers that the runs of one process have in common.
#pragma once

#include <memory>
#include <string>

#include "localization/mh_amcl/mh_amcl_models.hpp"
#include "tools/base/process/latest_few.hpp"

namespace castaway::testbed {

/// The models of `mh_amcl` on maps, built once; the latest few are kept. What a run gets does not
/// depend on whether it was built before.
class SharedModels {
 public:
  /// The models of a localizer on a map. `settings`: a text that is equal for equal settings only.
  std::shared_ptr<const localization::MhAmclModels> get(const std::string& settings,
                                                        const localization::MhAmclConfig& config,
                                                        const localization::OccupancyGrid& grid);

 private:
  LatestFew<localization::MhAmclModels> models_;
};

}  // namespace castaway::testbed
