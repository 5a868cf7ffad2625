/// The table of a data set's sequences.
#pragma once

#include <string>
#include <vector>

#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// The rows of sequences.csv, header first: metadata, difficulty and drawn values of each sequence.
std::vector<std::vector<std::string>> sequence_rows(const DatasetContents& contents);

}  // namespace castaway::testbed
