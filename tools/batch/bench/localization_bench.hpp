/// Benchmarks of the localizer's parts, each beside a plain reference (`plain_reference`,
/// `plain_match`) that does the same work.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// How often a measurement is repeated.
struct BenchEffort {
  double sample_s = 0.002;  ///< [s] A sample repeats the code until this much time has passed.
  double total_s = 0.5;     ///< [s] Samples are taken until this much time has passed.
  int samples = 101;        ///< Maximum number of samples. One is always taken.
};

/// Median over the samples of the CPU time of one call [s]. The first call is a warm-up and is not
/// counted unless it alone takes longer than `total_s`.
double median_cpu_time(const std::function<void()>& body, const BenchEffort& effort = {});

/// A step of the filter, with 5 populations of 200 particles and 180 beams.
struct StepTime {
  std::string step;
  double time_s = 0.0;   ///< [s] CPU time of one core for all populations.
  double plain_s = 0.0;  ///< [s] CPU time of the reference.
  double items = 0.0;    ///< Number of items processed.
  std::string item;      ///< Kind of item: "particles" or "particle beams".
};

/// A search of a whole map.
struct MatchTime {
  double width = 0.0;               ///< [m]
  double height = 0.0;              ///< [m]
  double cell = 0.0;                ///< [m] Resolution of the search.
  int yaws = 0;                     ///< Number of orientations.
  int points = 0;                   ///< Number of scan end points.
  double branch_s = 0.0;            ///< [s] CPU time of branch and bound.
  double exhaustive_s = 0.0;        ///< [s] CPU time of the exhaustive score volume.
  std::optional<double> plain_s{};  ///< [s] CPU time of the reference, if it was run.
};

/// Times these steps: predict; correct by end points (mode `improved`) and by rays (`paper`);
/// evidence of the populations; reseed; and a whole update, which is a prediction, a correction by
/// end points, moments, evidence and a reseed of every population.
std::vector<StepTime> time_steps(const BenchEffort& effort = {});

/// Times the matcher with its default configuration, on an office (`bench_scene`) of 5 cm cells.
MatchTime time_match(double width, double height, const BenchEffort& effort = {});

/// Times a search at the map's own resolution, 1 degree and 96 points, without the reference.
MatchTime time_fine_match(double width, double height, const BenchEffort& effort = {});

}  // namespace castaway::testbed
