#include "tools/batch/cluster/slurm_job.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const SharedCommand kCommand{"/opt/castaway",
                             "/home/me",
                             "/shared/out/slurm",
                             {"campaign", "my spec.yaml", "--out", "/shared/out", "--set", "a=b c"},
                             "range"};

TEST(SlurmJob, TheArrayMakesAShardPerTask) {
  EXPECT_EQ(array_script(kCommand, {.tasks = 8, .cores = 3}),
            "#!/bin/sh\n"
            "#SBATCH --job-name='range'\n"
            "#SBATCH --output='/shared/out/slurm/task-%j.log'\n"
            "#SBATCH --cpus-per-task=3\n"
            "#SBATCH --requeue\n"
            "cd '/home/me' && exec '/opt/castaway' 'campaign' 'my spec.yaml' '--out' '/shared/out' "
            "'--set' 'a=b c' -j 3 --shard \"$SLURM_ARRAY_TASK_ID/8\"\n");
}

TEST(SlurmJob, TheOtherJobCollects) {
  const std::string script =
      collect_script(kCommand, {.partition = "short", .time = "1:00", .extra = {"--mem=2G"}});
  for (const char* part : {"#SBATCH --partition='short'\n", "#SBATCH --time='1:00'\n",
                           "#SBATCH --mem=2G\n", " --collect\n", "collect-%j.log"}) {
    EXPECT_TRUE(contains(script, part)) << part;
  }
}

}  // namespace
}  // namespace castaway::testbed
