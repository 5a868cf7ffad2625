/// The plots and tables beside a data set's card.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// A file beside the sequences: its path relative to the data set's folder, and its bytes.
using DatasetFile = std::pair<std::string, std::string>;

/// plots/index.html and plots/coverage-<world>.png.
std::vector<DatasetFile> dataset_plots(const DatasetContents& contents);

/// The rows of sequences.csv, header first: metadata, difficulty and drawn values of each sequence.
std::vector<std::vector<std::string>> sequence_rows(const DatasetContents& contents);

}  // namespace castaway::testbed
