/// Training, validation and test splits of a data set.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/scenario/dataset_yaml.hpp"

namespace castaway::testbed {

inline constexpr std::array<const char*, 3> kSplitNames{"train", "val", "test"};

/// Assigns each sequence to a split.
struct DatasetSplits {
  std::vector<int> part;  ///< By sequence: an index into `kSplitNames`.
  std::string remark;     ///< A warning for the reader; empty if the splits are as requested.
};

/// Splits by world, so that no model is tested in a building it was trained on. Worlds are taken in
/// random order, and each goes to the split that is farthest below its share; but every split with
/// a share gets one world first, and train gets the largest. If there are fewer worlds than splits,
/// train is filled first, then test, and the remark says so. Splitting by sequence takes the
/// sequences in random order instead of the worlds.
DatasetSplits split_dataset(const std::vector<std::string>& worlds, const SplitSpec& spec,
                            std::uint64_t seed);

}  // namespace castaway::testbed
