#include "tools/live/live_report.hpp"

#include <unistd.h>

#include <stdexcept>

#include <gtest/gtest.h>

#include "tools/live/lines/pipes.hpp"

namespace castaway::testbed {
namespace {

std::string outcome_of(LiveReport& report) {
  for (int tries = 0; tries < 1000; ++tries) {
    if (const auto outcome = report.outcome()) return *outcome;
    usleep(10000);
  }
  return "never";
}

TEST(LiveReport, OneIsMadeAtATime) {
  LiveReport report;
  const Pipe go = open_pipe();
  const int line = dup(0);
  report.start([&] { (void)read_line(go.out); }, line);
  EXPECT_FALSE(report.outcome());
  EXPECT_THROW(report.start([] {}, line), std::runtime_error);
  EXPECT_TRUE(write_whole(go.in, "\n"));
  EXPECT_EQ(outcome_of(report), "");
  EXPECT_FALSE(report.outcome());
  report.start([] { throw std::runtime_error("no room on the disk"); }, line);
  EXPECT_EQ(outcome_of(report), "no room on the disk");
  report.start([] { _exit(3); }, line);
  EXPECT_EQ(outcome_of(report), "it broke off");
  for (const int file : {go.out, go.in, line}) close(file);
}

}  // namespace
}  // namespace castaway::testbed
