/// One sequence of a data set.
#pragma once

#include <filesystem>

#include "tools/dataset/dataset_worlds.hpp"
#include "tools/scenario/dataset_sample.hpp"

namespace castaway::testbed {

/// Plays the sequence into `draft` and writes its sequence.json, which says what it holds, how hard
/// it is and which files it has. The same sequence gives the same bytes. Throws FileError or
/// std::exception in one line where it cannot be made. `worlds` must know its scores.
void make_sequence(const DatasetSpec& spec, const DatasetWorlds& worlds,
                   const SampledSequence& sequence, const std::filesystem::path& draft);

}  // namespace castaway::testbed
