#include "tools/base/output/interruption.hpp"

#include <csignal>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(InterruptionDeathTest, TellsWhatIsKept) {
  const auto interrupt = [] {
    watch_for_interruption();
    const KeptWork kept("finished cells are kept in c");
    static_cast<void>(std::raise(SIGTERM));
  };
  EXPECT_EXIT(interrupt(), testing::ExitedWithCode(128 + SIGTERM),
              "interrupted; finished cells are kept in c\n");
}

TEST(InterruptionDeathTest, TellsThatNothingWasWritten) {
  const auto interrupt = [] {
    watch_for_interruption();
    { const KeptWork kept("finished cells are kept in c"); }
    static_cast<void>(std::raise(SIGINT));
  };
  EXPECT_EXIT(interrupt(), testing::ExitedWithCode(128 + SIGINT),
              "interrupted; nothing was written\n");
}

}  // namespace
}  // namespace castaway::testbed
