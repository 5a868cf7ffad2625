/// The last steps of a data set: tables, splits, maps, plots, card, manifest.
#pragma once

#include <string>

#include "tools/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Writes all files beside the sequences; the manifest comes last. Throws FileError.
void finish_dataset(const DatasetFolder& folder, const DatasetContents& contents);

/// Figures of the current invocation.
struct DatasetMaking {
  double wall_s = 0.0;  ///< For the sequences of this invocation.
  int made = 0;         ///< Number of these sequences.
  int workers = 1;
  double cpu_s = 0.0;       ///< Of the workers.
  double largest_mb = 0.0;  ///< Peak memory of the largest worker.
};

/// For the terminal: words.
std::string describe_dataset(const DatasetFolder& folder, const DatasetContents& contents,
                             const DatasetMaking& making);

/// For programs: JSON.
std::string dataset_json(const DatasetFolder& folder, const DatasetContents& contents,
                         const DatasetMaking& making);

}  // namespace castaway::testbed
