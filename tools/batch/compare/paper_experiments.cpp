#include "tools/batch/compare/paper_experiments.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr int kStartsOfAKind = 15;
constexpr std::uint64_t kStandingSeeds = 100'001;  // Keeps the seeds of the two kinds of starts
                                                   // disjoint.

using Parts = std::vector<ExperimentPart>;

Parts tracking_parts(int repeats) {
  Parts parts;
  for (const char* route : {"loop", "workshop", "loop-back", "workshop-back", "both"}) {
    parts.push_back({route,
                     "worlds/lab/scenarios/paper-tracking.yaml",
                     {fmt::format("drive.route={}", route)},
                     1,
                     repeats});
  }
  return parts;
}

Parts recovery_parts(int repeats) {
  const std::string scenario = "worlds/lab/scenarios/paper-recovery.yaml";
  const int runs = kStartsOfAKind * repeats;
  return {{"standing", scenario, {"drive.wait_s=10", "start.switch_on_s=0"}, kStandingSeeds, runs},
          {"moving", scenario, {}, 1, runs}};
}

Parts marathon_parts(int repeats) {
  return {{"marathon", "worlds/corridor/scenarios/paper-marathon.yaml", {}, 1, repeats}};
}

/// Reduces the experiment to two short runs of each of the first two parts, without expectations.
void shorten(Experiment& experiment) {
  if (experiment.parts.size() > 2) experiment.parts.resize(2);
  for (ExperimentPart& part : experiment.parts) {
    part.runs = 2;
    for (const char* less : {"duration_s=12", "stop_after_m=5", "expect=~"}) {
      part.overrides.emplace_back(less);
    }
  }
}

}  // namespace

Experiment paper_experiment(int number, int repeats, bool quick) {
  if (repeats < 1 || repeats > 1000) {
    throw std::invalid_argument(fmt::format("--seeds {}: give 1 to 1000 repeats", repeats));
  }
  Experiment experiment;
  experiment.number = number;
  if (number == 1) {
    experiment.title = "tracking: a known start, 5 itineraries of 2 minutes";
    experiment.parts = tracking_parts(repeats);
    experiment.paper = {{"error, mean +- sd [m]", "0.109 +- 0.039", "0.206 +- 0.098"},
                        {"error, median [m]", "0.105", "0.195"},
                        {"CPU per update [ms]", "6", "4"}};
  } else if (number == 2) {
    experiment.title = "recovery: unknown starts, half of them standing, half on the move";
    experiment.parts = recovery_parts(repeats);
    experiment.paper = {{"recovery time, mean [s]", "6.501", "13.714"},
                        {"success", "100 %", "26.67 %"}};
  } else if (number == 3) {
    experiment.title = "an hour: 2734 m up and down a corridor among people, by the estimate";
    experiment.parts = marathon_parts(repeats);
    experiment.paper = {{"distance [m]", "2734", ""},
                        {"time [h]", "1.1", ""},
                        {"recovery behaviours", "7", ""},
                        {"collisions", "0", ""},
                        {"emergency stops", "0", ""}};
  } else {
    throw std::invalid_argument(fmt::format("there is no experiment {}; give 1, 2 or 3", number));
  }
  if (quick) shorten(experiment);
  return experiment;
}

std::vector<ExperimentRun> runs_of(const Experiment& experiment) {
  std::vector<ExperimentRun> runs;
  for (const ExperimentPart& part : experiment.parts) {
    for (int i = 0; i < part.runs; ++i) {
      ExperimentRun run{part.name, part.scenario, part.overrides,
                        part.first_seed + static_cast<std::uint64_t>(i), ""};
      run.overrides.push_back(fmt::format("seed={}", run.seed));
      run.overrides.emplace_back("outputs.report=false");
      run.overrides.emplace_back("outputs.snapshots=false");
      run.folder = fmt::format("runs/{}/seed-{}", run.part, run.seed);
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace castaway::testbed
