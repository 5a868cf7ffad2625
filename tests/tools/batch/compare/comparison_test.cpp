#include "tools/batch/compare/comparison.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/run/metrics/metrics_json.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Content of a run folder.
struct Written {
  std::string scenario = "s";
  std::uint64_t seed = 1;
  double error = 0.1;
  std::string localizer = "a";
  std::string duration = "60";
  int version = kMetricsVersion;
};

void write_run(const fs::path& folder, const Written& run) {
  Json summary{{"metrics_version", run.version},
               {"scenario", run.scenario},
               {"seed", run.seed},
               {"collisions", 0}};
  summary["localizers"][run.localizer] = to_json(LocalizerMetrics{});
  summary["localizers"][run.localizer]["position_error_m"]["mean"] = run.error;
  fs::create_directories(folder);
  write_file(folder / "summary.json", summary.dump());
  write_file(folder / "scenario.yaml", "name: " + run.scenario + "\nduration_s: " + run.duration +
                                           "\nlocalizers: [" + run.localizer + "]\n");
}

/// Writes runs of consecutive seeds with the given errors.
void write_runs(const fs::path& folder, const std::vector<double>& errors) {
  for (std::size_t i = 0; i < errors.size(); ++i) {
    Written run;
    run.seed = i + 1;
    run.error = errors[i];
    write_run(folder / ("seed-" + std::to_string(run.seed)), run);
  }
}

std::string refused(const fs::path& a, const fs::path& b) {
  try {
    compare_runs(a, b);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing";
}

const MetricComparison& metric(const Comparison& comparison, const std::string& name) {
  for (const MetricComparison& row : comparison.metrics) {
    if (row.metric == name) return row;
  }
  throw std::out_of_range(name);
}

TEST(Comparison, IsOfPairsOfScenarioAndSeed) {
  const TemporaryFolder folder;
  write_runs(folder.path() / "a", {0.1, 0.5, 0.9});
  write_runs(folder.path() / "b", {0.3, 0.7, 1.1, 9.0});
  const Comparison comparison = compare_runs(folder.path() / "a", folder.path() / "b");
  EXPECT_EQ(comparison.pairs, 3U);
  EXPECT_EQ(comparison.unpaired, 1U);
  const MetricComparison& error = metric(comparison, "a.position_error_m.mean");
  EXPECT_EQ(error.pairs, 3U);
  EXPECT_NEAR(error.baseline, 0.5, 1e-12);
  EXPECT_NEAR(error.difference, 0.2, 1e-12);  // the same in every pair
  ASSERT_TRUE(error.interval);
  EXPECT_NEAR(error.interval->low, 0.2, 1e-9);
  EXPECT_NEAR(error.interval->high, 0.2, 1e-9);
  EXPECT_EQ(error.verdict(), 0);  // Three pairs have the same sign by chance in one of four cases.
  EXPECT_EQ(metric(comparison, "collisions").verdict(), 0);
}

/// Compares `count` seeds with runs whose errors are smaller by a tenth.
Comparison of_pairs(const fs::path& folder, int count) {
  std::vector<double> before;
  std::vector<double> after;
  for (int i = 0; i < count; ++i) {
    before.push_back(1.0 + 0.01 * i);
    after.push_back(before.back() - 0.1);
  }
  write_runs(folder / "a", before);
  write_runs(folder / "b", after);
  return compare_runs(folder / "a", folder / "b");
}

TEST(Comparison, CallsBetterWhatIsSoInEnoughPairs) {
  const TemporaryFolder folder;
  const MetricComparison error = metric(of_pairs(folder.path(), 10), "a.position_error_m.mean");
  EXPECT_EQ(error.verdict(), 1);
}

// With all differences of one sign, p is 2 / 2^pairs, and Holm's correction multiplies the smallest
// one by the number of metrics.
TEST(Comparison, SaysHowManyPairsItTakes) {
  const TemporaryFolder folder;
  const Comparison few = of_pairs(folder.path() / "few", 2);
  const auto judged = static_cast<double>(few.metrics.size());
  const auto needed = static_cast<int>(std::floor(std::log2(2.0 * judged / 0.05))) + 1;
  for (const MetricComparison& row : few.metrics) {
    EXPECT_EQ(row.pairs_needed, static_cast<std::size_t>(needed)) << row.metric;
  }
  EXPECT_EQ(to_json(few)["metrics"]["collisions"]["pairs_needed"], needed);
  const Comparison short_of = of_pairs(folder.path() / "short", needed - 1);
  EXPECT_TRUE(metric(short_of, "a.position_error_m.mean").pairs_needed);
  const Comparison enough = of_pairs(folder.path() / "enough", needed);
  const MetricComparison error = metric(enough, "a.position_error_m.mean");
  EXPECT_FALSE(error.pairs_needed);
  EXPECT_EQ(error.verdict(), 1);
}

TEST(Comparison, IsCorrectedForTheNumberOfMetrics) {
  const TemporaryFolder folder;
  const Comparison comparison = of_pairs(folder.path(), 6);
  const MetricComparison error = metric(comparison, "a.position_error_m.mean");
  const auto judged = static_cast<double>(comparison.metrics.size());
  EXPECT_NEAR(error.p_value.value(), judged * 2.0 / 64.0, 1e-12);
  EXPECT_EQ(error.verdict(), 0);  // Without the correction its p-value of 0.03 would be
                                  // significant.
}

TEST(Comparison, NeverJudgesAClock) {
  const TemporaryFolder folder;
  of_pairs(folder.path(), 10);
  for (const auto& [side, ms] : {std::pair{"a", 1.0}, std::pair{"b", 2.0}}) {
    for (int seed = 1; seed <= 10; ++seed) {
      const Json timing{{"localizers", {{"a", {{"update_ms", {{"mean", ms}}}}}}}};
      write_file(folder.path() / side / ("seed-" + std::to_string(seed)) / "timing.json",
                 timing.dump());
    }
  }
  const Comparison comparison = compare_runs(folder.path() / "a", folder.path() / "b");
  const MetricComparison& clock = metric(comparison, "timing.localizers.a.update_ms.mean");
  EXPECT_DOUBLE_EQ(clock.difference, 1.0);
  EXPECT_FALSE(clock.p_value);
  EXPECT_EQ(clock.verdict(), 0);
  EXPECT_EQ(comparison.metrics.back().metric, clock.metric);
}

TEST(Comparison, PairsRunsThatShareScenarioAndSeedByTheirConditions) {
  const TemporaryFolder folder;
  for (const char* side : {"a", "b"}) {
    for (const char* duration : {"60", "90", "120"}) {
      Written run;
      run.duration = duration;
      run.error = 0.001 * std::stod(duration);
      write_run(folder.path() / side / duration, run);
    }
  }
  const Comparison comparison = compare_runs(folder.path() / "a", folder.path() / "b");
  EXPECT_EQ(comparison.pairs, 3U);
  EXPECT_EQ(comparison.unpaired, 0U);
  EXPECT_DOUBLE_EQ(metric(comparison, "a.position_error_m.mean").difference, 0.0);
}

TEST(Comparison, SeesNoDifferenceWhereTheIntervalHoldsNone) {
  const TemporaryFolder folder;
  write_runs(folder.path() / "a", {0.1, 0.5, 0.9});
  write_runs(folder.path() / "b", {0.3, 0.4, 0.9});
  EXPECT_EQ(
      metric(compare_runs(folder.path() / "a", folder.path() / "b"), "a.position_error_m.mean")
          .verdict(),
      0);
}

TEST(Comparison, OfOnePairHasNoInterval) {
  const TemporaryFolder folder;
  write_run(folder.path() / "a", {});
  Written other;
  other.error = 0.05;
  write_run(folder.path() / "b", other);
  const Json json = to_json(compare_runs(folder.path() / "a", folder.path() / "b"));
  EXPECT_EQ(json.at("pairs"), 1);
  const Json& error = json.at("metrics").at("a.position_error_m.mean");
  EXPECT_EQ(error.at("difference"), -0.05);
  EXPECT_TRUE(error.at("interval").is_null());
}

TEST(Comparison, RefusesWhatIsNotComparableAndSaysWhy) {
  const TemporaryFolder folder;
  const fs::path a = folder.path() / "a";
  write_run(a, {});
  const auto other = [&](const char* name, const Written& run) {
    write_run(folder.path() / name, run);
    return folder.path() / name;
  };
  EXPECT_TRUE(contains(refused(a, other("scenario", {.scenario = "t"})), "is of scenario 's'"));
  EXPECT_TRUE(contains(refused(a, other("seed", {.seed = 2})), "no seed is common"));
  EXPECT_TRUE(contains(refused(a, other("long", {.duration = "90"})), "'duration_s' differs"));
  EXPECT_TRUE(contains(refused(a, other("old", {.version = 1})), "metrics of version 2"));
  EXPECT_TRUE(contains(refused(a, other("name", {.localizer = "b"})), "no localizer in common"));
  EXPECT_TRUE(contains(refused(a, folder.path() / "nothing"), "no run here"));
}

TEST(FindRuns, LeavesOutSummariesOfSeveralRuns) {
  const TemporaryFolder folder;
  write_runs(folder.path(), {0.1, 0.2});
  write_file(folder.path() / "summary.json", R"({"kind": "seeds"})");
  EXPECT_EQ(find_runs(folder.path()).size(), 2U);
}

}  // namespace
}  // namespace castaway::testbed
