#include "tools/base/process/child_process.hpp"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/process/line_channel.hpp"
#include "tools/base/process/process_use.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

/// False also for a process that ended and was not waited for.
bool is_running(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(stat, text);
  const std::size_t end = text.rfind(')');
  return end != std::string::npos && text[end + 2] != 'Z';
}

TEST(ChildProcess, ExchangesLines) {
  ChildProcess program(shell("while read line; do echo \"<$line>\"; done"), {});
  LineChannel channel(program);
  EXPECT_EQ(channel.exchange("a b\n", std::chrono::seconds(10)), "<a b>");
  EXPECT_EQ(channel.exchange("c\n", std::chrono::seconds(10)), "<c>");
}

TEST(ChildProcess, ExchangesMoreThanAPipeHolds) {
  ChildProcess program({"cat"}, {});
  LineChannel channel(program);
  const std::string line(500'000, 'x');
  EXPECT_EQ(channel.exchange(line + "\n", std::chrono::seconds(20)), line);
}

TEST(ChildProcess, SaysWhyAProgramCannotBeStarted) {
  EXPECT_EQ(error_of([] { ChildProcess program({"/no/such/program"}, {}); }),
            "cannot start '/no/such/program': No such file or directory");
  EXPECT_EQ(error_of([] { ChildProcess program({"/etc/passwd"}, {}); }),
            "cannot start '/etc/passwd': Permission denied");
}

TEST(ChildProcess, TellsHowItEnded) {
  ChildProcess exits(shell("exit 3"), {});
  EXPECT_EQ(exits.how_it_ended(std::chrono::seconds(10)), "exited with 3");
  ChildProcess dies(shell("kill -SEGV $$"), {});
  EXPECT_EQ(dies.how_it_ended(std::chrono::seconds(10)),
            "was killed by signal 11 (Segmentation fault)");
  ChildProcess runs({"sleep", "100"}, {});
  EXPECT_EQ(runs.how_it_ended(milliseconds(0)), std::nullopt);
}

TEST(ChildProcess, WritesStandardErrorToItsLog) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "mine.log";
  {
    ChildProcess program(shell("echo one >&2; echo two >&2"), log);
    (void)program.how_it_ended(std::chrono::seconds(10));
  }
  EXPECT_EQ(read_file(log), "one\ntwo\n");
}

TEST(ChildProcess, LimitsItsLog) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "mine.log";
  {
    ChildProcess program(shell("head -c 20000000 /dev/zero >&2"), log);
    EXPECT_EQ(program.how_it_ended(std::chrono::seconds(60)), "exited with 0");
  }
  EXPECT_EQ(std::filesystem::file_size(log), static_cast<std::uintmax_t>(kLongestLog));
}

/// Even those that left the program's session and process group.
/// The number that a program writes first.
pid_t first_number(const ChildProcess& program) {
  std::string line;
  for (int i = 0; i < 100 && line.empty(); ++i) {
    std::this_thread::sleep_for(milliseconds(20));
    std::string text(100, '\0');
    const ssize_t size = ::read(program.output(), text.data(), text.size());
    if (size > 0) line = text.substr(0, static_cast<std::size_t>(size));
  }
  return std::stoi(line);
}

TEST(ChildProcess, EndsAllDescendants) {
  pid_t descendant = 0;
  {
    ChildProcess program(shell("setsid sh -c 'sleep 100 & echo $!; wait' & wait"), {});
    descendant = first_number(program);
    EXPECT_TRUE(is_running(descendant));
  }
  EXPECT_FALSE(is_running(descendant));
}

TEST(ChildProcess, EndsAProgramThatStopsItsParent) {
  ChildProcess program(shell("kill -STOP $PPID; echo $$; sleep 100"), {});
  const pid_t process = first_number(program);
  const auto begin = std::chrono::steady_clock::now();
  program.end();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  EXPECT_FALSE(is_running(process));
}

TEST(ChildProcess, EndsTheDescendantsOfAProgramThatKillsItsParent) {
  ChildProcess program(shell("setsid sleep 100 & echo $!; kill -9 $PPID; sleep 100"), {});
  const pid_t descendant = first_number(program);
  EXPECT_EQ(program.how_it_ended(std::chrono::seconds(10)), "was killed by signal 9 (Killed)");
  program.end();
  EXPECT_FALSE(is_running(descendant));
}

TEST(ChildProcess, CountsTheCpuTimeOfDescendants) {
  ChildProcess program(
      shell("sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done'; echo done; read line"), {});
  ProcessUse use(program.id());
  (void)program.how_it_ended(milliseconds(1));
  LineChannel channel(program);
  std::this_thread::sleep_for(milliseconds(1500));
  EXPECT_GT(use.peak_memory_mb(), 0.1);
  EXPECT_GT(program.end(), milliseconds(20));
}

TEST(LineChannel, WaitsNoLongerThanItShould) {
  ChildProcess program({"sleep", "100"}, {});
  LineChannel channel(program);
  EXPECT_EQ(error_of([&] { (void)channel.exchange("a\n", milliseconds(50)); }),
            "did not answer within 0.05 s");
}

TEST(LineChannel, TellsWhatTheProgramDid) {
  ChildProcess ends(shell("read line; exit 5"), {});
  LineChannel to_end(ends);
  EXPECT_EQ(error_of([&] { (void)to_end.exchange("a\n", std::chrono::seconds(10)); }),
            "exited with 5");
  ChildProcess closes(shell("exec >&-; sleep 100"), {});
  LineChannel to_close(closes);
  EXPECT_EQ(error_of([&] { (void)to_close.exchange("a\n", std::chrono::seconds(10)); }),
            "closed its standard output");
  ChildProcess floods({"yes"}, {});
  LineChannel to_flood(floods);
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(error_of([&] { (void)to_flood.exchange("a\n", std::chrono::seconds(10)); }),
            "answered before it was asked");
  ChildProcess rambles(shell("read line; tr '\\0' x < /dev/zero"), {});
  LineChannel to_ramble(rambles);
  EXPECT_EQ(error_of([&] { (void)to_ramble.exchange("a\n", std::chrono::seconds(10)); }),
            "answered more than 1048576 bytes");
}

}  // namespace
}  // namespace castaway::testbed
