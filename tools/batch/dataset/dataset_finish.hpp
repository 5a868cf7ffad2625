/// The last steps of a data set: tables, splits, maps, plots, card, manifest.
#pragma once

#include <string>

#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Writes all files beside the sequences, the manifest last; `pages` makes card and plots. Throws
/// FileError.
void finish_dataset(const DatasetFolder& folder, const DatasetContents& contents,
                    const DatasetPages& pages);

/// Figures of the current invocation.
struct DatasetInvocation {
  double wall_s = 0.0;  ///< Time spent on the sequences made in this invocation.
  int made = 0;         ///< Number of sequences made in this invocation.
  int workers = 1;
  double cpu_s = 0.0;       ///< CPU time of all workers.
  double largest_mb = 0.0;  ///< Peak memory of the largest worker.
};

/// Report for the terminal.
std::string describe_dataset(const DatasetFolder& folder, const DatasetContents& contents,
                             const DatasetInvocation& invocation);

/// Report as JSON.
std::string dataset_json(const DatasetFolder& folder, const DatasetContents& contents,
                         const DatasetInvocation& invocation);

}  // namespace castaway::testbed
