/// A finished data set's sequences, as their sequence.json say.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/dataset/dataset_folder.hpp"
#include "tools/dataset/dataset_manifest.hpp"
#include "tools/dataset/dataset_splits.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/scenario/dataset_spec.hpp"

namespace castaway::testbed {

/// All that a card can say.
struct DatasetContents {
  DatasetSpec spec;
  std::vector<std::string> names;                 ///< "000042"
  std::vector<nlohmann::ordered_json> sequences;  ///< sequence.json of each, without its files.
  std::vector<std::uintmax_t> bytes;              ///< Of each.
  std::vector<ManifestFile> files;                ///< Of all, by path from the data set's folder.
  DatasetSplits splits;
  std::map<std::string, RosMap> maps;  ///< By world.

  /// The sum of a figure of all sequences; `pointer`: "/scans".
  [[nodiscard]] double sum(const char* pointer) const;
  /// A figure of each sequence that has it.
  [[nodiscard]] std::vector<double> figures(const char* pointer) const;
  /// The sum of lists of counts, "/statistics/ranges".
  [[nodiscard]] std::vector<double> counts(const char* pointer) const;
  /// Of all files of sequences.
  [[nodiscard]] std::uintmax_t all_bytes() const;
};

/// Of values in any order, at least one; 0: the least, 1: the most.
double quantile(std::vector<double> values, double q);

/// Reads the sequences. Throws std::runtime_error naming a file that cannot be read.
DatasetContents load_contents(const DatasetFolder& folder, const DatasetSpec& spec,
                              const std::vector<std::string>& names,
                              const std::map<std::string, RosMap>& maps);

}  // namespace castaway::testbed
