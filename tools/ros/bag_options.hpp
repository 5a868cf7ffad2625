/// What a bag of a run holds besides the usual.
#pragma once

#include "tools/ros/mcap/mcap_records.hpp"

namespace castaway::testbed {

/// Choices about a bag.
struct BagOptions {
  McapCompression compression = McapCompression::kZstd;
  bool particles = false;  ///< All particles of all localizers.
  bool snapshots = false;  ///< The run's pictures, if it takes any.
};

}  // namespace castaway::testbed
