/// One sequence of a data set.
#pragma once

#include <filesystem>

#include "tools/batch/dataset/dataset_worlds.hpp"
#include "tools/build/shared_worlds.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/scenario/dataset_sample.hpp"

namespace castaway::testbed {

/// What the sequences of one process have in common.
struct PartsOfSequences {
  ReportWriter report;  ///< Of a run, where the specification asks for one.
  SharedWorlds worlds{};
};

/// Simulates the sequence into `draft` and writes its sequence.json: contents, difficulty and list
/// of files. The same sequence gives the same bytes. Throws FileError, or a std::exception of one
/// line, if it cannot be made. Precondition: `worlds` has the scores of the sequence's scenario.
/// `parts`: of this process.
void make_sequence(const DatasetSpec& spec, const DatasetWorlds& worlds,
                   const SampledSequence& sequence, const std::filesystem::path& draft,
                   PartsOfSequences& parts);

}  // namespace castaway::testbed
