/// Training, validation and test parts of a data set.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/scenario/dataset_spec.hpp"

namespace castaway::testbed {

inline constexpr std::array<const char*, 3> kSplitNames{"train", "val", "test"};

/// Which sequence is in which part.
struct DatasetSplits {
  std::vector<int> part;  ///< By sequence: an index into `kSplitNames`.
  std::string remark;     ///< What a reader must know; empty: it is as asked for.
};

/// Splits by world, so that nobody is tested in a building that he learned: worlds in a drawn order
/// go where most is missing, but every part with a share has one first, train the largest. With
/// fewer worlds than parts train comes first, then test, and the remark says so. By sequence: in a
/// drawn order, in the shares' numbers.
DatasetSplits split_dataset(const std::vector<std::string>& worlds, const SplitSpec& spec,
                            std::uint64_t seed);

}  // namespace castaway::testbed
