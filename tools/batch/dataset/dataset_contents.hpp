/// The sequences of a finished data set, as read from their sequence.json files.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/base/formats/ros_map.hpp"
#include "tools/batch/dataset/dataset_folder.hpp"
#include "tools/batch/dataset/dataset_manifest.hpp"
#include "tools/batch/dataset/dataset_splits.hpp"
#include "tools/scenario/dataset_yaml.hpp"

namespace castaway::testbed {

/// All inputs of a data set's card.
struct DatasetContents {
  DatasetSpec spec;
  std::vector<std::string> names;                 ///< Such as "000042".
  std::vector<nlohmann::ordered_json> sequences;  ///< sequence.json of each sequence, without its
                                                  ///< list of files.
  std::vector<std::uintmax_t> bytes;              ///< Size of each sequence.
  std::vector<ManifestFile> files;                ///< Files of all sequences; paths relative to the
                                                  ///< data set's folder.
  DatasetSplits splits;
  std::map<std::string, RosMap> maps;  ///< By world.

  /// Sums a figure over all sequences; `pointer` is a JSON pointer such as "/scans".
  [[nodiscard]] double sum(const char* pointer) const;
  /// Values of a figure, from the sequences that have it.
  [[nodiscard]] std::vector<double> figures(const char* pointer) const;
  /// Sums a list of counts, such as "/statistics/ranges", bin by bin over all sequences.
  [[nodiscard]] std::vector<double> counts(const char* pointer) const;
  /// Total size of the files of all sequences.
  [[nodiscard]] std::uintmax_t all_bytes() const;
};

/// The `q` quantile of values in any order, at least one; `q` 0 is the minimum, 1 the maximum.
double quantile(std::vector<double> values, double q);

/// Reads the sequences. Throws std::runtime_error naming a file that cannot be read.
DatasetContents load_contents(const DatasetFolder& folder, const DatasetSpec& spec,
                              const std::vector<std::string>& names,
                              const std::map<std::string, RosMap>& maps);

/// A file beside the sequences: its path relative to the data set's folder, and its bytes.
using DatasetFile = std::pair<std::string, std::string>;

/// Makes the card (README.md) and the plots of a data set.
using DatasetPages = std::function<std::vector<DatasetFile>(const DatasetContents&)>;

}  // namespace castaway::testbed
