/// How fast the parts of the localizer are, each beside a plain reference (`plain_reference`,
/// `plain_match`) that does the same work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/bench/bench_timer.hpp"

namespace castaway::testbed {

/// A step of the filter, on 5 populations of 200 particles and 180 beams.
struct StepTime {
  std::string step;
  double time_s = 0.0;   ///< [s] CPU time of one core for all populations.
  double plain_s = 0.0;  ///< [s] Of the reference.
  double items = 0.0;    ///< How many of...
  std::string item;      ///< ..."particles" or "particle beams" that is.
};

/// A search of a whole map.
struct MatchTime {
  double width = 0.0;               ///< [m]
  double height = 0.0;              ///< [m]
  double cell = 0.0;                ///< [m] Of the search...
  int yaws = 0;                     ///< ...in so many orientations...
  int points = 0;                   ///< ...by so many end points.
  double branch_s = 0.0;            ///< [s] CPU time of branch and bound,
  double exhaustive_s = 0.0;        ///< [s] of the exhaustive score volume,
  std::optional<double> plain_s{};  ///< [s] of the reference, where it was asked.
};

/// Steps: predict; correct by end points (mode `improved`) and by rays (`paper`); evidence of the
/// populations; reseed; and the whole update: a prediction, a correction by end points, moments,
/// evidence and a reseed of every population.
std::vector<StepTime> time_steps(const BenchEffort& effort = {});

/// The matcher as it is configured, on an office (`bench_scene`) of 5 cm cells.
MatchTime time_match(double width, double height, const BenchEffort& effort = {});

/// The same at the map's own cells, every degree, by 96 points; without the reference.
MatchTime time_fine_match(double width, double height, const BenchEffort& effort = {});

}  // namespace castaway::testbed
