// Data sets whose process is killed while they are made.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "localization/geometry/random.hpp"
#include "tests/program/dataset_files.hpp"

namespace castaway::test {
namespace {

/// Starts the command, kills it after a while, and returns whether it was killed in time.
bool killed_after(const fs::path& folder, std::chrono::microseconds wait) {
  const pid_t process = fork();
  if (process == 0) {
    if (chdir(folder.c_str()) != 0) _exit(9);
    if (freopen("/dev/null", "w", stdout) == nullptr) _exit(9);
    execl(CASTAWAY_PROGRAM, "castaway", "dataset", "s.yaml", "-n", "6", "-j", "2", "--out", "set",
          nullptr);
    _exit(9);
  }
  std::this_thread::sleep_for(wait);
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  return WIFSIGNALED(status);
}

// CASTAWAY_KILLS sets the number of kills; the default is 4.
TEST(Dataset, KilledAtAnyMomentItGoesOnAndComesOutTheSame) {
  const fs::path folder = folder_with_spec();
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 6 -j 2 --out whole").exit_code, 0);
  const auto whole = std::chrono::steady_clock::now() - begin;
  const char* wanted = std::getenv("CASTAWAY_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 4;
  localization::Rng rng = localization::substream(1, "kills");
  int killed = 0;
  for (int tries = 0; killed < kills; ++tries) {
    const auto most = std::chrono::duration_cast<std::chrono::microseconds>(whole).count();
    killed += killed_after(folder, std::chrono::microseconds(
                                       rng() % static_cast<std::uint64_t>(std::max<long>(most, 1))))
                  ? 1
                  : 0;
    if (!fs::exists(folder / "set/manifest.json")) continue;
    expect_equal(folder / "whole", folder / "set");  // It finished before it could be killed.
    fs::remove_all(folder / "set");
  }
  const Outcome last = castaway(folder, "dataset s.yaml -n 6 -j 2 --out set");
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_equal(folder / "whole", folder / "set");
}

}  // namespace
}  // namespace castaway::test
