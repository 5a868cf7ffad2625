/// Reproduces one sequence of a data set.
#pragma once

#include "tools/batch/dataset/dataset_run.hpp"

namespace castaway::testbed {

/// Reproduces sequence `index` byte for byte in the folder `out`.
int make_only(const DatasetRequest& request, int index);

}  // namespace castaway::testbed
