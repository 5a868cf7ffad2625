/// The files of a data set and how to load them, as Markdown.
#pragma once

#include <string>

#include "tools/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Says what is there, and nothing of what is not.
std::string describe_formats(const DatasetContents& contents);

}  // namespace castaway::testbed
