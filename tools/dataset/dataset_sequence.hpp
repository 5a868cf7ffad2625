/// One sequence of a data set.
#pragma once

#include <filesystem>

#include "tools/dataset/dataset_worlds.hpp"
#include "tools/scenario/dataset_sample.hpp"
#include "tools/sources/shared_worlds.hpp"

namespace castaway::testbed {

/// Simulates the sequence into `draft` and writes its sequence.json: contents, difficulty and list
/// of files. The same sequence gives the same bytes. Throws FileError, or a std::exception of one
/// line, if it cannot be made. Precondition: `worlds` has the scores of the sequence's scenario.
/// `shared`: of this process.
void make_sequence(const DatasetSpec& spec, const DatasetWorlds& worlds,
                   const SampledSequence& sequence, const std::filesystem::path& draft,
                   SharedWorlds& shared);

}  // namespace castaway::testbed
