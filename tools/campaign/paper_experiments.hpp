/// The experiments of A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable
/// Multi-Hypothesis Monte Carlo Localization for Mobile Robots", 2022, section V, as runs in the
/// simulator.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Runs of one scenario that differ by their seed.
struct ExperimentPart {
  std::string name;                    ///< Names its folder.
  std::string scenario;                ///< File under the data root.
  std::vector<std::string> overrides;  ///< key=value
  std::uint64_t first_seed = 1;
  int runs = 1;
};

/// A line of the paper's table.
struct PaperFigure {
  std::string label;
  std::string mh_amcl;  ///< As printed there.
  std::string amcl;     ///< Empty: the paper has none.
};

/// One experiment.
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
  std::vector<std::string> overrides;  ///< The part's, the seed and what is not written.
  std::uint64_t seed = 1;
  std::string folder;  ///< Relative to the experiment's.
};

/// Experiment 1, 2 or 3. `repeats` [1, 1000]: how often each of the paper's runs is made, with
/// other seeds. `quick`: a small version for tests, whose figures mean nothing. Throws
/// std::invalid_argument for another number.
Experiment paper_experiment(int number, int repeats, bool quick);

/// All its runs, in order.
std::vector<ExperimentRun> runs_of(const Experiment& experiment);

}  // namespace castaway::testbed
