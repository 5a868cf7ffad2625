/// The files of a data set and how to load them, as Markdown.
#pragma once

#include <string>

#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Describes only the formats that the data set contains.
std::string describe_formats(const DatasetContents& contents);

}  // namespace castaway::testbed
