/// Optional content of a run's bag.
#pragma once

#include "tools/base/bytes/compression.hpp"
#include "tools/ros/storage/mcap_records.hpp"

namespace castaway::testbed {

/// Options of a bag.
struct BagOptions {
  Compression compression = Compression::kZstd;
  bool particles = false;  ///< Write all particles of all localizers.
  bool points = true;      ///< Write all layers of 3-D lidars as clouds.
  bool clouds = false;     ///< Write scans and particles as clouds, too.
  bool snapshots = false;  ///< Write the run's pictures, if it takes any.
};

}  // namespace castaway::testbed
