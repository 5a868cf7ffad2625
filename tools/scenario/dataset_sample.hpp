/// The scenarios of a data set's sequences.
#pragma once

#include "tools/scenario/dataset_spec.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// A sequence before it is run.
struct SampledSequence {
  int index = 0;
  std::uint64_t seed = 0;  ///< Of its run; fits in a double without loss.
  std::vector<std::pair<std::string, std::string>> drawn;  ///< Key and value, in order of the spec.
  LoadedScenario loaded;
};

/// "000042"
std::string sequence_name(int index);

/// Draws sequence `index`. Its seed comes from the substream "sequence/<index>" of the root seed,
/// every value from "sequence/<index>/<key>": one more key or one more sequence changes no other
/// draw. Throws std::runtime_error in one line naming file, sequence, key and value where the
/// scenario that comes out cannot be.
SampledSequence sample_sequence(const DatasetSpec& spec, int index);

/// One line for something that is wrong with a sequence: file, sequence, what, and the drawn values
/// that it may come from.
std::string sequence_trouble(const DatasetSpec& spec, const SampledSequence& sequence,
                             const std::string& what);

}  // namespace castaway::testbed
