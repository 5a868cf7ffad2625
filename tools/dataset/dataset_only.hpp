/// Makes one sequence of a data set again.
#pragma once

#include "tools/dataset/dataset_run.hpp"

namespace castaway::testbed {

/// Makes sequence `index` again, as folder `out`, byte for byte.
int make_only(const DatasetRequest& request, int index);

}  // namespace castaway::testbed
