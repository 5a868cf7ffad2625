#include "tools/live/checkpoints.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using localization::from_seconds;

/// What `body` and the copies of its process wrote until all of them had ended.
template <typename Body>
std::string written_by(Body body) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    body(ends[1]);
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  char byte = 0;
  while (read(ends[0], &byte, 1) == 1) text += byte;
  close(ends[0]);
  waitpid(process, nullptr, 0);
  return text;
}

void say(int file, const std::string& text) {
  EXPECT_EQ(write(file, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

/// Counts to 6 and keeps the even numbers; goes back to 3 once, and then to the beginning.
void count(int file) {
  Checkpoints checkpoints;
  int went_back = 0;
  for (int i = 0; i <= 6; ++i) {
    if (i % 2 == 0) {
      // A copy is woken with the number of times that the count went back.
      while (const auto woken = checkpoints.keep(from_seconds(i))) went_back = std::stoi(*woken);
    }
    say(file, std::to_string(i));
  }
  const double to = went_back == 0 ? 3.0 : 0.0;
  if (went_back < 2 && checkpoints.wake(from_seconds(to), std::to_string(went_back + 1))) _exit(0);
  say(file, "end");
}

TEST(Checkpoints, GoBackAndOnAgain) { EXPECT_EQ(written_by(count), "0123456234560123456end"); }

TEST(Checkpoints, EndWithTheProcessThatCouldWakeThem) {
  const std::string text = written_by([](int file) {
    Checkpoints checkpoints;
    for (int i = 0; i < 5; ++i) {
      if (checkpoints.keep(from_seconds(i))) say(file, "woken");
    }
    say(file, "gone");
    _exit(1);  // Without a farewell.
  });
  EXPECT_EQ(text, "gone");  // All copies had ended: the pipe was closed.
}

TEST(Checkpoints, AreFewAndSparserInThePast) {
  const std::string text = written_by([](int file) {
    Checkpoints checkpoints(6);
    for (int i = 0; i <= 1000; ++i) {
      if (checkpoints.keep(from_seconds(i))) return;
    }
    const auto times = checkpoints.times();
    if (times.size() != 6 || times.front() != from_seconds(0.0)) say(file, "wrong number");
    if (times.back() != from_seconds(1000.0)) say(file, "not the newest");
    if (times[4] < from_seconds(990.0)) say(file, "not the latest");
    if (times[1] < from_seconds(400.0) || times[1] > from_seconds(900.0)) say(file, "not the past");
  });
  EXPECT_EQ(text, "");
}

TEST(Checkpoints, BeforeTheFirstThereIsNothing) {
  const std::string text = written_by([](int file) {
    Checkpoints checkpoints;
    if (checkpoints.keep(from_seconds(2.0))) return;
    if (!checkpoints.wake(from_seconds(1.0), "x")) say(file, "none");
  });
  EXPECT_EQ(text, "none");
}

}  // namespace
}  // namespace castaway::testbed
