#include "tools/batch/cluster/repeated_command.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Words = std::vector<std::string>;

TEST(RepeatedCommand, LeavesOutWhatEachProcessIsToldItself) {
  const Words words{
      "evaluate", "logs/a",      "-j",         "4",      "-j2",       "--jobs=3",
      "--slurm",  "--partition", "short",      "--json", "--time=1:", "--sbatch",
      "--mem=1G", "--shard",     "1/2",        "--out",  "o",         "--metric",
      "x",        "--rank",      "--starts=3", "--set",  "a=-j",      "--retry-failed"};
  EXPECT_EQ(shared_words(words), (Words{"evaluate", "logs/a", "--out", "o", "--starts=3", "--set",
                                        "a=-j", "--retry-failed"}));
  EXPECT_EQ(asked_words(words), (Words{"evaluate", "logs/a", "--starts=3", "--set", "a=-j"}));
}

TEST(RepeatedCommand, IsBoundToTheFilesThatItNames) {
  const TemporaryFolder folder;
  folder.put("log/log.carmen", "one");
  folder.put("mine.yaml", "one");
  const std::string log = (folder.path() / "log").string();
  const std::string option = "--localizer=" + (folder.path() / "mine.yaml").string();
  const Words words{"evaluate", log, option};
  const std::string before = hash_of_named_files(words);
  EXPECT_EQ(hash_of_named_files(words), before);
  EXPECT_NE(hash_of_named_files({"evaluate", log}), before);
  folder.put("mine.yaml", "two");
  const std::string changed = hash_of_named_files(words);
  EXPECT_NE(changed, before);
  folder.put("log/log.carmen", "two");
  EXPECT_NE(hash_of_named_files(words), changed);
}

TEST(RepeatedCommand, OfASeedIsALineForAShell) {
  const Words words{"run",
                    "ci/my gate.yaml",
                    "--seeds=20",
                    "-j",
                    "2",
                    "--out",
                    "gate",
                    "--junit",
                    "gate.xml",
                    "--markdown",
                    "sum.md",
                    "--set",
                    "a.b=3",
                    "--localizer",
                    "program:python3 it's.py",
                    "--force"};
  EXPECT_EQ(command_of_seed(words, 7),
            "castaway run 'ci/my gate.yaml' --set a.b=3 --localizer 'program:python3 it'\\''s.py' "
            "--seed 7 --out look");
}

}  // namespace
}  // namespace castaway::testbed
