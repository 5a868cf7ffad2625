/// What a data set is made of, as YAML.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/scenario/draw_spec.hpp"

namespace castaway::testbed {

/// A key of the scenario that differs from sequence to sequence.
struct VariedKey {
  std::string path;  ///< As of `--set`: "people.count", "events.0.kidnap.at_s".
  Draw draw;
  std::string where;  ///< "file:line"
};

/// Shares of a data set for learning.
struct SplitSpec {
  double train = 0.8;
  double val = 0.1;
  double test = 0.1;
  bool by_sequence = false;  ///< False: all sequences of a world are in one part.
};

/// What sequences are drawn from.
struct DatasetSpec {
  std::string file;  ///< Names it in errors.
  std::string name;
  std::string description;
  std::string license;          ///< Of the data; empty: none is stated.
  std::uint64_t seed = 1;       ///< Root of all draws.
  std::filesystem::path base;   ///< Folder that relative paths of the scenario start from.
  YamlNode scenario;            ///< What all sequences share.
  std::vector<VariedKey> vary;  ///< In order of the file; later ones go over earlier ones.
  SplitSpec splits;
  std::string effective;  ///< YAML that gives the same data set, its scenario within.
};

/// What the command line says besides.
struct DatasetOverrides {
  std::optional<std::uint64_t> seed;  ///< Instead of the file's.
  std::vector<std::string> scenario;  ///< key=value, of the scenario.
};

/// Reads a specification:
///
///     name: office-people
///     license: CC-BY-4.0
///     seed: 1
///     scenario: office/people        # a shipped one, a path, or the scenario itself as a map
///     vary:                          # `read_draw` says how
///       people.count: {integer: [0, 12]}
///       world: {choice: [office, home]}
///     outputs: {bag: true, tables: hdf5}   # instead of those of the scenario
///     splits: {train: 0.8, val: 0.1, test: 0.1, by: world}
///
/// Without `outputs` a sequence has a bag and tables; without `localizers` in the scenario none
/// rides along. Throws std::runtime_error or std::invalid_argument naming file, line, key, value
/// and remedy.
DatasetSpec load_dataset_spec(const std::filesystem::path& file,
                              const DatasetOverrides& overrides = {});

}  // namespace castaway::testbed
