#include "tools/batch/cluster/command_output.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(CommandOutput, HasBothStreamsAndTheExitCode) {
  const CommandOutput output = run_command({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(output.out, "out\n");
  EXPECT_EQ(output.err, "err\n");
  EXPECT_EQ(output.exit_code, 3);
  EXPECT_EQ(run_command({"sh", "-c", "kill -9 $$"}).exit_code, 137);
}

TEST(CommandOutput, MayBeLongerThanAPipeHolds) {
  const CommandOutput output = run_command({"sh", "-c", "seq 100000; seq 100000 >&2"});
  EXPECT_EQ(output.out.size(), 588895U);
  EXPECT_EQ(output.err, output.out);
}

TEST(CommandOutput, FailsWithWhatTheProgramSays) {
  EXPECT_EQ(output_of({"echo", "a b"}), "a b\n");
  EXPECT_EQ(error_of([] {
              output_of({"sh", "-c", "echo no such job >&2; exit 1"});
            }),
            "sh failed with 1: no such job");
  EXPECT_TRUE(contains(error_of([] { output_of({"no-such-program"}); }), "cannot run"));
}

TEST(ShellWord, IsReadAsItIs) {
  for (const std::string word : {"plain", "two words", "it's", "$HOME `x` \"y\" \\"}) {
    EXPECT_EQ(output_of({"sh", "-c", "printf %s " + shell_word(word)}), word);
  }
}

}  // namespace
}  // namespace castaway::testbed
