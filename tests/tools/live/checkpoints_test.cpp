#include "tools/live/checkpoints.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>

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

/// Processes of this one's group.
int processes_of_group() {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    const bool is_process = name.find_first_not_of("0123456789") == std::string::npos;
    count += is_process && getpgid(std::stoi(name)) == getpgrp() ? 1 : 0;
  }
  return count;
}

TEST(Checkpoints, ThatAreGivenUpEndAtOnce) {
  const std::string text = written_by([](int file) {
    setpgid(0, 0);
    std::signal(SIGCHLD, SIG_IGN);  // Nobody waits for them.
    Checkpoints checkpoints(4);
    for (int i = 0; i < 40; ++i) {
      if (checkpoints.keep(from_seconds(i))) return;
    }
    for (int tries = 0; tries < 200 && processes_of_group() > 5; ++tries) usleep(10000);
    if (processes_of_group() != 5) say(file, "too many");
    checkpoints.clear();
    for (int tries = 0; tries < 200 && processes_of_group() > 1; ++tries) usleep(10000);
    if (processes_of_group() != 1) say(file, "not cleared");
  });
  EXPECT_EQ(text, "");
}

/// Comes to 3, goes back to 2 and gives up all but the first and the newest; a copy that was made
/// before knows those that are gone.
TEST(Checkpoints, OneThatAnotherCopyGaveUpIsPassedOver) {
  const std::string text = written_by([](int file) {
    std::signal(SIGPIPE, SIG_IGN);
    Checkpoints checkpoints(3);
    for (int i = 0; i <= 6; ++i) {
      if (const auto woken = checkpoints.keep(from_seconds(i))) {
        say(file, "at " + std::to_string(i) + ";");
        if (i > 0 && !checkpoints.wake(from_seconds(i - 1), "again")) say(file, "none;");
        _exit(0);
      }
    }
    usleep(200000);  // Those that are given up end.
    checkpoints.wake(from_seconds(6.0), "first");
  });
  EXPECT_EQ(text.substr(0, 5), "at 6;");
  EXPECT_EQ(text.substr(text.size() - 5), "at 0;");
}

}  // namespace
}  // namespace castaway::testbed
