/// The experiments of A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable
/// Multi-Hypothesis Monte Carlo Localization for Mobile Robots", 2022, section V, as simulated
/// runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Runs of one scenario that differ only in their seed.
struct ExperimentPart {
  std::string name;                    ///< Also the name of its folder.
  std::string scenario;                ///< File relative to the data root.
  std::vector<std::string> overrides;  ///< Entries "key=value".
  std::uint64_t first_seed = 1;
  int runs = 1;
};

/// A row of the paper's table.
struct PaperFigure {
  std::string label;
  std::string mh_amcl;  ///< As printed in the paper.
  std::string amcl;     ///< Empty if the paper has no value.
};

struct Experiment {
  int number = 1;
  std::string title;
  std::vector<ExperimentPart> parts;
  std::vector<PaperFigure> paper;
};

/// A run of an experiment.
struct ExperimentRun {
  std::string part;
  std::string scenario;
  std::vector<std::string> overrides;  ///< Those of the part, the seed and the outputs that are
                                       ///< switched off.
  std::uint64_t seed = 1;
  std::string folder;  ///< Relative to the experiment's folder.
};

/// Returns experiment 1, 2 or 3. `repeats` [1, 1000]: number of times each of the paper's runs is
/// made, with different seeds. `quick`: a small version for tests, whose results are meaningless.
/// Throws std::invalid_argument for another number.
Experiment paper_experiment(int number, int repeats, bool quick);

/// All runs of the experiment, in order.
std::vector<ExperimentRun> runs_of(const Experiment& experiment);

}  // namespace castaway::testbed
