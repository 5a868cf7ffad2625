#include "tools/live/live_trial.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/live/lines/pipes.hpp"

namespace castaway::testbed {
namespace {

/// What a process says that tries `work`: "copy" after a success, or what was thrown.
std::string tried(const std::function<void()>& work, const TrialLimits& limits) {
  const Pipe line = open_pipe();
  const int process = fork_with(line);
  if (process == 0) {
    const pid_t before = getpid();
    try {
      try_in_copy(work, limits);
      write_whole(line.in, before == getpid() ? "the same process" : "copy");
    } catch (const std::exception& error) {
      write_whole(line.in, before == getpid() ? error.what() : "the copy goes on");
    }
    _exit(0);
  }
  close(line.in);
  std::string text = read_to_end(line.out);
  close(line.out);
  waitpid(process, nullptr, 0);
  return text;
}

TEST(TryInCopy, TheCopyGoesOnAfterASuccess) {
  EXPECT_EQ(tried([] {}, {}), "copy");
}

TEST(TryInCopy, TheProcessGoesOnAfterAFailure) {
  EXPECT_EQ(tried([] { throw std::runtime_error("no such wall"); }, {}), "no such wall");
  EXPECT_EQ(tried([] { std::abort(); }, {}), "it takes too much memory, or broke off");
}

TEST(TryInCopy, ATrialHasLimitedTime) {
  TrialLimits limits;
  limits.patience = std::chrono::seconds(1);
  EXPECT_EQ(tried([] { pause(); }, limits), "it takes too long");
}

TEST(TryInCopy, ATrialHasLimitedMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer reserves terabytes";
#endif
  TrialLimits limits;
  limits.memory = std::size_t{1} << 30U;
  const auto greedy = [] {
    const std::vector<char> much(std::size_t{2} << 30U, 'x');
    if (much.back() != 'x') std::abort();
  };
  EXPECT_EQ(tried(greedy, limits), "std::bad_alloc");
}

}  // namespace
}  // namespace castaway::testbed
