// Tests of Ctrl-C and SIGTERM.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "tests/program/dataset_files.hpp"

namespace castaway::test {
namespace {

using namespace std::chrono_literals;

/// Starts the command with stderr in stderr.txt, sends a signal once `ready` returns true, and
/// returns the outcome.
Outcome interrupted(const fs::path& folder, const std::string& arguments, int signal,
                    const std::function<bool()>& ready) {
  fs::remove(folder / "stdout.txt");
  const pid_t process = fork();
  if (process == 0) {
    const std::string command = "cd '" + folder.string() + "' && exec '" + CASTAWAY_PROGRAM + "' " +
                                arguments + " >stdout.txt 2>stderr.txt";
    setpgid(0, 0);
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(9);
  }
  bool is_ready = ready();
  for (int i = 0; i < 30000 && !is_ready; ++i) {  // Five minutes: the machine may be busy.
    std::this_thread::sleep_for(10ms);
    is_ready = ready();
  }
  EXPECT_TRUE(is_ready) << "castaway " << arguments << " did not come so far";
  kill(process, signal);
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
          text_of(folder / "stdout.txt"), text_of(folder / "stderr.txt")};
}

const std::string kLong = "run --duration 20000 --set outputs.snapshots=false";

TEST(Interruption, ARunSaysSoAndLeavesNothing) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    const fs::path folder = fresh_folder();
    const Outcome outcome = interrupted(folder, kLong, signal, [&] {
      return fs::exists(folder / "runs/lab-kidnap/seed-1/.castaway-unfinished/scenario.yaml");
    });
    EXPECT_EQ(outcome.exit_code, code);
    EXPECT_EQ(outcome.err, "castaway: interrupted; nothing was written\n");
    EXPECT_FALSE(fs::exists(folder / "runs"));
  }
}

TEST(Interruption, ARunKeepsTheRunBefore) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "run --duration 2 --set outputs.snapshots=false --out a").exit_code,
            0);
  const auto before = files_of(folder / "a");
  const Outcome outcome = interrupted(folder, kLong + " --out a", SIGINT, [&] {
    return fs::exists(folder / "a/.castaway-unfinished/scenario.yaml");
  });
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(files_of(folder / "a"), before);
}

TEST(Interruption, ManySeedsGoOnWhereTheyWereStopped) {
  const std::string seeds = "run --duration 30 --set outputs.snapshots=false --seeds 6 -j 2 --out ";
  const fs::path folder = fresh_folder();
  const Outcome outcome = interrupted(folder, seeds + "part", SIGTERM, [&] {
    return fs::exists(folder / "part/seed-1/summary.json") &&
           fs::exists(folder / "part/seed-2/summary.json");
  });
  ASSERT_EQ(outcome.exit_code, 143);
  expect_contains(outcome.err, "castaway: interrupted; ");
  expect_contains(outcome.err, " of 6 runs are kept in part; the same command resumes\n");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (int seed = 1; seed <= 6; ++seed) {
    EXPECT_FALSE(
        fs::exists(folder / ("part/seed-" + std::to_string(seed)) / ".castaway-unfinished"));
  }
  const auto written = fs::last_write_time(folder / "part/seed-1/summary.json");
  ASSERT_EQ(castaway(folder, seeds + "part").exit_code, 0);
  EXPECT_EQ(fs::last_write_time(folder / "part/seed-1/summary.json"), written);
  ASSERT_EQ(castaway(folder, seeds + "whole").exit_code, 0);
  EXPECT_EQ(text_of(folder / "part/summary.json"), text_of(folder / "whole/summary.json"));
  EXPECT_EQ(text_of(folder / "part/.castaway.json"), text_of(folder / "whole/.castaway.json"));
}

TEST(Interruption, ManySeedsGoOnAfterAKill) {
  const std::string seeds =
      "run --duration 30 --set outputs.snapshots=false --seeds 4 -j 2 --out part";
  const fs::path folder = fresh_folder();
  const Outcome outcome = interrupted(folder, seeds, SIGKILL, [&] {
    return fs::exists(folder / "part/seed-1/summary.json") &&
           fs::exists(folder / "part/seed-3/.castaway-unfinished");
  });
  EXPECT_EQ(outcome.exit_code, -SIGKILL);
  const auto written = fs::last_write_time(folder / "part/seed-1/summary.json");
  const Outcome again = castaway(folder, seeds);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(fs::last_write_time(folder / "part/seed-1/summary.json"), written);
  EXPECT_FALSE(fs::exists(folder / "part/seed-3/.castaway-unfinished"));
}

TEST(Interruption, ADataSetGoesOn) {
  const fs::path folder = folder_with_spec();
  const Outcome outcome = interrupted(folder, "dataset s.yaml -n 6 -j 2 --out set", SIGINT,
                                      [&] { return fs::exists(folder / "set/sequences/000000"); });
  ASSERT_EQ(outcome.exit_code, 130);
  expect_contains(outcome.err, "of 6 sequences are finished; the same command resumes");
  EXPECT_FALSE(fs::exists(folder / "set/.work"));
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 6 -j 2 --out set").exit_code, 0);
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 6 -j 2 --out whole").exit_code, 0);
  expect_equal(folder / "whole", folder / "set");
}

TEST(Interruption, CommandsThatWriteNothingSaySo) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder,
                     "run --duration 20 --set events=[] --set outputs.snapshots=false --set "
                     "outputs.carmen=true --set outputs.map=true --out made")
                .exit_code,
            0);
  const Outcome outcome = interrupted(
      folder, "evaluate made --starts 100 --kidnaps 0 --window 15", SIGINT,
      [&] { return !text_of(folder / "stdout.txt").empty(); });  // The head of the table.
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.err, "castaway: interrupted; nothing was written\n");
}

}  // namespace
}  // namespace castaway::test
