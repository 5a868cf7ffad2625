/// The step in which a lidar states its ranges.
#pragma once

#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// The step of quantised ranges: the largest usual step of which nearly all are multiples; 0 if
/// there is none. [m]
double find_resolution(const std::vector<float>& ranges);

/// That of some of a log's scans.
double find_resolution(const AlignedLog& log);

}  // namespace castaway::testbed
