// Tests castaway campaign --slurm with stand-ins for Slurm's commands. They run each task at once.
#include "tests/program/campaign_files.hpp"
#include "tests/program/slurm_stand_in.hpp"

namespace castaway::test {
namespace {

fs::path folder_with_slurm() {
  const fs::path folder = folder_with_grid();
  put_slurm(folder);
  return folder;
}

TEST(Slurm, GivesTheTablesOfOneProcess) {
  const fs::path folder = folder_with_slurm();
  const Outcome made = on_slurm(folder,
                                "campaign s.yaml --out c --slurm --array-size 4 -j 2 --time 10:00 "
                                "--partition short --sbatch=--mem=1G --set lidar.beams=30");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_contains(made.err, "job 71 with 4 tasks, and job 72 for the tables");
  const std::string calls = text_of(folder / "bin/calls");
  expect_contains(calls, "--parsable --array=1-4 c/array.sh\n");
  expect_contains(calls, "--parsable --dependency=afterany:71 c/collect.sh\n");
  const std::string script = text_of(folder / "c/array.sh");
  for (const char* line : {"#SBATCH --partition='short'", "#SBATCH --time='10:00'",
                           "#SBATCH --mem=1G", "#SBATCH --cpus-per-task=2", "#SBATCH --requeue",
                           "-j 2 --shard \"$SLURM_ARRAY_TASK_ID/4\""}) {
    expect_contains(script, line);
  }
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out one --set lidar.beams=30").exit_code, 0);
  expect_same_tables(folder / "c", folder / "one");
  const Outcome again = on_slurm(folder, "campaign s.yaml --out c --attach --set lidar.beams=30");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out, made.out);
}

TEST(Slurm, SubmitsAgainWhatTheSchedulerLost) {
  const fs::path folder = folder_with_slurm();
  write(folder / "bin/lose", "");
  const Outcome made = on_slurm(folder, "campaign s.yaml --out c --slurm --array-size 3");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_contains(made.err, "shards 2 of 3 ended with cells missing; submitted again");
  expect_contains(text_of(folder / "bin/calls"), "--array=2 c/array.sh");
  ASSERT_EQ(castaway(folder, "campaign s.yaml --out one").exit_code, 0);
  expect_same_tables(folder / "c", folder / "one");
}

TEST(Slurm, GivesUpWhereShardsNeverEnd) {
  const fs::path folder = folder_with_slurm();
  write(folder / "bin/sbatch", "#!/bin/sh\necho 5\n");
  const Outcome made = on_slurm(folder, "campaign s.yaml --out c --slurm --array-size 2");
  EXPECT_EQ(made.exit_code, 1);
  expect_contains(made.err, "cells are missing: 0, 1, 2");
  const auto times_submitted_again = [](const std::string& text) {
    int times = 0;
    for (std::size_t at = text.find("submitted again"); at != std::string::npos;
         at = text.find("submitted again", at + 1)) {
      ++times;
    }
    return times;
  };
  EXPECT_EQ(times_submitted_again(made.err), 2);
  const Outcome again = on_slurm(folder, "campaign s.yaml --out c --attach");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(times_submitted_again(again.err), 0);
}

TEST(Slurm, MakesDataSets) {
  const fs::path folder = folder_with_spec();
  put_slurm(folder);
  write(folder / "bin/lose", "");
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 5 --out one").exit_code, 0);
  const Outcome made =
      on_slurm(folder, "dataset s.yaml -n 5 --out set --slurm --array-size 2 -j 2");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_contains(made.err, "shards 2 of 2 ended with sequences missing; submitted again");
  expect_equal(folder / "one", folder / "set");
  EXPECT_TRUE(fs::exists(folder / "set.slurm/array.sh"));
  EXPECT_EQ(castaway(folder, "dataset --verify set").exit_code, 0);
}

TEST(Slurm, RefusesInOneLine) {
  const fs::path folder = folder_with_slurm();
  expect_refused(on_slurm(folder, "campaign s.yaml --out c --attach"), {"c", "no campaign.json"});
  expect_refused(on_slurm(folder, "campaign s.yaml --out c --slurm --collect"),
                 {"--slurm", "--collect"});
  expect_refused(castaway(folder, "campaign s.yaml --out c --time 1:00"), {"--time", "--slurm"});
  write(folder / "bin/sbatch", "#!/bin/sh\necho 'sbatch: error: no partition x' >&2\nexit 1\n");
  expect_refused(on_slurm(folder, "campaign s.yaml --out c --slurm"), {"no partition x"});
  write(folder / "c/slurm.json", R"({"array": "5", "collect": "6", "tasks": 2, "tries": 1})");
  write(folder / "bin/squeue", "#!/bin/sh\necho R\n");
  expect_refused(on_slurm(folder, "campaign s.yaml --out c --slurm"), {"job 5", "--attach"});
}

}  // namespace
}  // namespace castaway::test
