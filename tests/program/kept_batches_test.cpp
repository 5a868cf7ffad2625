// Tests commands of many trials that keep their results: evaluate, bench kidnaps, twin.
#include <chrono>
#include <iterator>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/program/killed.hpp"
#include "tests/program/slurm_stand_in.hpp"
#include "tests/tools/support/recorded_office.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const std::string kEvaluate =
    "evaluate office --starts 2 --kidnaps 1 --window 4 --localizer mh_amcl --localizer amcl ";
const std::string kKidnaps =
    "bench kidnaps --kidnaps 3 --obstacles 0 --obstacles 2 --window 4 --localizer mh_amcl ";

fs::path folder_with_office() {
  const fs::path folder = fresh_folder();
  testbed::write_office(testbed::recorded_office(60), folder / "office");
  return folder;
}

/// The rows of a summary without CPU times.
Json rows_in(const fs::path& folder) {
  Json rows = Json::parse(text_of(folder / "summary.json"));
  for (Json& row : rows) {
    row.erase("cpu_mean_ms");
    row.erase("cpu_max_ms");
  }
  return rows;
}

std::size_t rows_kept(const fs::path& file) {
  const std::string text = text_of(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(KeptBatches, PrintWhatTheyPrintWithoutAFolder) {
  const fs::path folder = folder_with_office();
  const Outcome kept = castaway(folder, kEvaluate + "--out e -j 2");
  ASSERT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_EQ(rows_kept(folder / "e/rows.jsonl"), 8U);
  const Outcome plain = castaway(folder, kEvaluate + "--json");
  Json rows = Json::parse(plain.out);
  for (Json& row : rows) {
    row.erase("cpu_mean_ms");
    row.erase("cpu_max_ms");
  }
  EXPECT_EQ(rows_in(folder / "e"), rows);
  // All rows are there: nothing is made, the same is printed.
  const Outcome again = castaway(folder, kEvaluate + "--out e");
  EXPECT_EQ(again.out, kept.out);
  EXPECT_EQ(rows_kept(folder / "e/rows.jsonl"), 8U);
}

TEST(KeptBatches, GoOnWhereTheyWereKilled) {
  const fs::path folder = folder_with_office();
  ASSERT_EQ(castaway(folder, kKidnaps + "--out whole -j 2").exit_code, 0);
  std::istringstream line(kKidnaps + "--out k");
  const std::vector<std::string> words{std::istream_iterator<std::string>(line), {}};
  std::size_t least = 6;
  for (const int ms : {150, 500, 900}) {
    killed_after(folder, words, std::chrono::milliseconds(ms));
    const fs::path rows = folder / "k/rows.jsonl";
    least = std::min(least, fs::exists(rows) ? rows_kept(rows) : 0U);
  }
  EXPECT_LT(least, 6U);
  const Outcome again = castaway(folder, kKidnaps + "--out k");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(rows_kept(folder / "k/rows.jsonl"), 6U);
  EXPECT_EQ(text_of(folder / "k/summary.json"), text_of(folder / "whole/summary.json"));
}

TEST(KeptBatches, AreSharedByProcesses) {
  const fs::path folder = folder_with_office();
  ASSERT_EQ(castaway(folder, kEvaluate + "--out one").exit_code, 0);
  const Outcome first = castaway(folder, kEvaluate + "--out e --shard 1/2");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, "");
  expect_contains(first.err, "--collect");
  const Outcome early = castaway(folder, kEvaluate + "--out e --collect");
  EXPECT_EQ(early.exit_code, 1);
  expect_contains(early.err, "trials are missing: 1, 3, 5, 7");
  ASSERT_EQ(castaway(folder, kEvaluate + "--out e --shard 2/2").exit_code, 0);
  const Outcome whole = castaway(folder, kEvaluate + "--out e --collect");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(rows_in(folder / "e"), rows_in(folder / "one"));
}

TEST(KeptBatches, RunOnSlurm) {
  const fs::path folder = folder_with_office();
  put_slurm(folder);
  ASSERT_EQ(castaway(folder, kKidnaps + "--out one").exit_code, 0);
  write(folder / "bin/lose", "");
  const Outcome made = on_slurm(folder, kKidnaps + "--out k --slurm --array-size 2 -j 2");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_contains(made.err, "shards 2 of 2 ended with trials missing; submitted again");
  EXPECT_EQ(text_of(folder / "k/summary.json"), text_of(folder / "one/summary.json"));
}

TEST(KeptBatches, RecordWhatFailsAndTryItAgain) {
  const fs::path folder = folder_with_office();
  write(folder / "mine.sh", "#!/bin/sh\n[ -e better ] || exit 3\nexec " CASTAWAY_SOURCE_DIR
                            "/examples/program/dead_reckoning.sh\n");
  fs::permissions(folder / "mine.sh", fs::perms::owner_all);
  const std::string line =
      "evaluate office --starts 1 --kidnaps 1 --window 2 --no-tracking --localizer program:" +
      (folder / "mine.sh").string() + " --out e ";
  const Outcome failed = castaway(folder, line);
  EXPECT_EQ(failed.exit_code, 1) << failed.err;
  EXPECT_EQ(failed.out, "");
  expect_contains(failed.err, "trial 1 failed: ");
  expect_contains(failed.err, "trials failed: 0, 1; --retry-failed makes them again");
  EXPECT_FALSE(fs::exists(folder / "e/summary.json"));
  write(folder / "better", "");
  EXPECT_EQ(castaway(folder, line).exit_code, 1);
  const Outcome again = castaway(folder, line + "--retry-failed");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(fs::exists(folder / "e/summary.json"));
}

TEST(KeptBatches, RefuseOtherCommandsAndChangedLogs) {
  const fs::path folder = folder_with_office();
  const std::string line = "evaluate office --starts 1 --kidnaps 0 --window 2 --no-tracking ";
  ASSERT_EQ(castaway(folder, line + "--out e").exit_code, 0);
  expect_refused(castaway(folder, line + "--seed 2 --out e"), {"e:", "evaluation.yaml", "--out"});
  expect_refused(castaway(folder, kKidnaps + "--out e"), {"e:", "no kidnaps"});
  expect_refused(castaway(folder, line + "--shard 1/2"), {"--shard", "--out DIR"});
  expect_refused(castaway(folder, line + "--out e --shard 3/2"), {"--shard needs I/N"});
  expect_refused(castaway(folder, line + "--out none --collect"), {"none", "evaluation.json"});
  write(folder / "office/log.carmen", text_of(folder / "office/log.carmen") + "# more\n");
  expect_refused(castaway(folder, line + "--out e"), {"e:", "files have changed"});
}

const std::string kSeeds = "run lab/kidnap --duration 8 --localizer mh_amcl --seeds 4 ";

/// What several seeds amount to, without clocks.
void expect_same_seeds(const fs::path& a, const fs::path& b) {
  for (const char* file : {"summary.json", "seed-1/errors.csv", "seed-4/summary.json"}) {
    EXPECT_FALSE(text_of(a / file).empty()) << file;
    EXPECT_EQ(text_of(a / file), text_of(b / file)) << file;
  }
}

TEST(SharedSeeds, AreSummedUpWhenAllShardsAreDone) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kSeeds + "--out one -j 2").exit_code, 0);
  const Outcome first = castaway(folder, kSeeds + "--out r --shard 1/2");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  expect_contains(first.out, "Shard 1 of 2: 2 runs made");
  EXPECT_FALSE(fs::exists(folder / "r/summary.json"));
  const Outcome early = castaway(folder, kSeeds + "--out r --collect");
  EXPECT_NE(early.exit_code, 0);
  expect_contains(early.err, "r: runs are missing: seed-2, seed-4; run their shards again");
  ASSERT_EQ(castaway(folder, kSeeds + "--out r --shard 2/2").exit_code, 0);
  const Outcome whole = castaway(folder, kSeeds + "--out r --collect");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  expect_same_seeds(folder / "one", folder / "r");
  expect_refused(castaway(folder, "run lab/kidnap --out q --shard 1/2"), {"--shard", "--seeds"});
}

TEST(SharedSeeds, RunOnSlurm) {
  const fs::path folder = fresh_folder();
  put_slurm(folder);
  ASSERT_EQ(castaway(folder, kSeeds + "--out one -j 2").exit_code, 0);
  write(folder / "bin/lose", "");
  const Outcome made = on_slurm(folder, kSeeds + "--out r --slurm --array-size 2");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_contains(made.err, "shards 2 of 2 ended with runs missing; submitted again");
  expect_same_seeds(folder / "one", folder / "r");
  EXPECT_TRUE(fs::exists(folder / "r.slurm/slurm.json"));
}

const std::string kExperiment = "experiment 2 --quick --seeds 2 ";

void expect_same_experiment(const fs::path& a, const fs::path& b) {
  for (const char* file : {"summary.json", "runs.csv"}) {
    EXPECT_FALSE(text_of(a / file).empty()) << file;
    EXPECT_EQ(text_of(a / file), text_of(b / file)) << file;
  }
}

TEST(SharedExperiments, AreSummedUpWhenAllShardsAreDone) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kExperiment + "--out one -j 2").exit_code, 0);
  const Outcome first = castaway(folder, kExperiment + "--out e --shard 1/2");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  expect_contains(first.out, "Shard 1 of 2: ");
  EXPECT_FALSE(fs::exists(folder / "e/summary.json"));
  const Outcome early = castaway(folder, kExperiment + "--out e --collect");
  EXPECT_NE(early.exit_code, 0);
  expect_contains(early.err, "e: runs are missing: ");
  ASSERT_EQ(castaway(folder, kExperiment + "--out e --shard 2/2").exit_code, 0);
  const Outcome whole = castaway(folder, kExperiment + "--out e --collect");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  expect_same_experiment(folder / "one", folder / "e");
  expect_refused(castaway(folder, kExperiment + "--shard 1/2"), {"--shard", "--out DIR"});
}

TEST(SharedExperiments, RunOnSlurm) {
  const fs::path folder = fresh_folder();
  put_slurm(folder);
  ASSERT_EQ(castaway(folder, kExperiment + "--out one -j 2").exit_code, 0);
  write(folder / "bin/lose", "");
  const Outcome made = on_slurm(folder, kExperiment + "--out e --slurm --array-size 2");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_contains(made.err, "shards 2 of 2 ended with runs missing; submitted again");
  expect_same_experiment(folder / "one", folder / "e");
  EXPECT_TRUE(fs::exists(folder / "e.slurm/slurm.json"));
}

}  // namespace
}  // namespace castaway::test
