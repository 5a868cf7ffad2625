/// The card and the plots beside a data set's sequences.
#pragma once

#include <vector>

#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// README.md, plots/index.html and plots/coverage-<world>.png.
std::vector<DatasetFile> dataset_pages(const DatasetContents& contents);

}  // namespace castaway::testbed
