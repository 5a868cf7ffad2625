/// Makes data sets.
#pragma once

#include <filesystem>

#include "tools/scenario/dataset_spec.hpp"

namespace castaway::testbed {

/// What the command line says.
struct DatasetRequest {
  std::filesystem::path spec;
  DatasetOverrides overrides;
  int sequences = 1;
  int workers = 1;
  std::filesystem::path out;
  bool json = false;
};

/// Makes what is missing of the data set in `out` and finishes it. Prints what it amounts to;
/// returns kRunFailed, with a line on stderr, where a sequence failed or nothing could be written:
/// finished sequences stay, and the same call goes on with the rest. Throws std::exception for a
/// specification that cannot be, or an `out` that holds something else, before anything is made.
int make_dataset(const DatasetRequest& request);

}  // namespace castaway::testbed
