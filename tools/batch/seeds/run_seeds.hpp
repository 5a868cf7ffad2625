/// castaway run --seeds: runs one scenario with many seeds in parallel.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/base/process/seed_range.hpp"
#include "tools/batch/cluster/slurm_batch.hpp"
#include "tools/batch/jobs/batch_request.hpp"
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
  BatchRequest batch;  ///< `out` holds a folder for each seed; empty: the default.
  std::string label;   ///< Of a default folder that is taken (OutputRequest).
  bool force = false;  ///< The folder may hold other files, too.
  std::vector<Expectation> expectations;           ///< Besides those of the scenario.
  std::filesystem::path junit;                     ///< Empty: none is written.
  std::filesystem::path markdown;                  ///< Of the summary; empty: none is written.
  bool strict = false;                             ///< As in `WorldChoice`.
  FilePrograms programs = FilePrograms::kRefused;  ///< As in `load_scenario`.
  bool json = false;         ///< Prints the aggregate summary.json instead of words.
  ReportWriter report{};     ///< Of each run, where the scenario asks for one.
  RunsPageRenderer index{};  ///< Renders index.html, likewise.
  /// The command that plays one seed again; with `markdown`.
  std::function<std::string(std::uint64_t seed)> repeat{};
};

/// Plays every seed into `out`/seed-<n> and writes the aggregate into `out`: summary.json (`kind`
/// "seeds"), timing.json and, where the runs have reports, index.html; a shard only its runs.
/// Returns the exit code: kRunFailed if a run failed or is missing, else kExpectationNotMet if an
/// expectation was not met.
int run_seeds(SeedsRequest request);

/// Plays them on a cluster, as `follow_on_cluster` does; scripts and logs are in `<out>.slurm`.
int run_seeds_on_slurm(SeedsRequest request, const ClusterRequest& cluster);

}  // namespace castaway::testbed
