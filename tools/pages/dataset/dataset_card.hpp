/// The card (README.md) of a data set.
#pragma once

#include <string>

#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Writes the card as Markdown: contents, provenance, statistics, plots, and how to load each
/// format. The same data set gives the same text.
std::string dataset_card(const DatasetContents& contents);

}  // namespace castaway::testbed
