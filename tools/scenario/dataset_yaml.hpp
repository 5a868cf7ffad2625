/// Specification of a data set, as YAML.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/scenario/draw_yaml.hpp"
#include "tools/scenario/localizers/foreign_yaml.hpp"

namespace castaway::testbed {

/// A scenario key whose value is drawn for each sequence.
struct VariedKey {
  std::string path;  ///< As for `--set`: "people.count", "events.0.kidnap.at_s".
  Draw draw;
  std::string where;  ///< "file:line"
};

/// Shares of the training, validation and test splits.
struct SplitSpec {
  double train = 0.8;
  double val = 0.1;
  double test = 0.1;
  bool by_sequence = false;  ///< If false, all sequences of a world are in the same split.
};

/// A data set specification.
struct DatasetSpec {
  std::string file;  ///< For errors.
  std::string name;
  std::string description;
  std::string license;         ///< License of the data; empty if none is stated.
  std::uint64_t seed = 1;      ///< Root of all draws.
  std::filesystem::path base;  ///< Folder that relative paths of the scenario start from.
  FilePrograms programs = FilePrograms::kRefused;  ///< As the user said, not the file.
  YamlNode scenario;                               ///< Base scenario of all sequences.
  std::vector<VariedKey> vary;  ///< In the order of the file; later entries override earlier ones.
  SplitSpec splits;
  std::string effective;  ///< YAML that reproduces the data set, with the scenario included.
};

/// Values from the command line.
struct DatasetOverrides {
  std::optional<std::uint64_t> seed;  ///< Overrides the file's seed.
  std::vector<std::string> scenario;  ///< Overrides of the scenario, as key=value.
  FilePrograms programs = FilePrograms::kRefused;
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
/// By default, a sequence has a bag and tables as outputs and no localizers. Throws
/// std::runtime_error or std::invalid_argument naming file, line, key, value and remedy.
DatasetSpec load_dataset_spec(const std::filesystem::path& file,
                              const DatasetOverrides& overrides = {});

}  // namespace castaway::testbed
