/// Samples the scenarios of a data set's sequences.
#pragma once

#include "tools/scenario/dataset_yaml.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A sampled sequence that has not been run yet.
struct SampledSequence {
  int index = 0;
  std::uint64_t seed = 0;  ///< Seed of its run; exactly representable as a double.
  std::vector<std::pair<std::string, std::string>> drawn;  ///< Keys and values, in the order of the
                                                           ///< specification.
  LoadedScenario loaded;
};

/// Name of a sequence, such as "000042".
std::string sequence_name(int index);

/// Draws sequence `index`. Its seed comes from the substream "sequence/<index>" of the root seed,
/// every value from "sequence/<index>/<key>", so adding a key or a sequence changes no other draw.
/// Throws std::runtime_error with one line naming file, sequence, key and value if the resulting
/// scenario is invalid.
SampledSequence sample_sequence(const DatasetSpec& spec, int index);

/// One line that describes an error of a sequence: file, sequence, error, and the drawn values that
/// may have caused it.
std::string sequence_error(const DatasetSpec& spec, const SampledSequence& sequence,
                           const std::string& what);

}  // namespace castaway::testbed
