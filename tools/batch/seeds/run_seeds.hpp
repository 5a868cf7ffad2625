/// castaway run --seeds: runs one scenario with many seeds in parallel.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/base/process/seed_range.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/play/shown_runs.hpp"
#include "tools/run/metrics/expectation.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {

/// The runs to make.
struct SeedsRequest {
  std::filesystem::path scenario;      ///< Its file.
  std::vector<std::string> overrides;  ///< key=value, without the seed.
  SeedRange seeds;
  int workers = 1;
  std::filesystem::path out;              ///< Holds a folder for each seed; empty: the default.
  std::string label;                      ///< Of a default folder that is taken (OutputRequest).
  bool force = false;                     ///< The folder may hold other files, too.
  std::vector<Expectation> expectations;  ///< Besides those of the scenario.
  std::filesystem::path junit;            ///< Empty: none is written.
  bool strict = false;                    ///< As in `WorldChoice`.
  FilePrograms programs = FilePrograms::kRefused;  ///< As in `load_scenario`.
  bool json = false;         ///< Prints the aggregate summary.json instead of words.
  ReportWriter report{};     ///< Of each run, where the scenario asks for one.
  RunsPageRenderer index{};  ///< Renders index.html, likewise.
};

/// Plays every seed into `out`/seed-<n> and writes the aggregate into `out`: summary.json (`kind`
/// "seeds"), timing.json and, where the runs have reports, index.html. Returns the exit code:
/// kRunFailed if a run failed, else kExpectationNotMet if an expectation was not met.
int run_seeds(SeedsRequest request);

}  // namespace castaway::testbed
