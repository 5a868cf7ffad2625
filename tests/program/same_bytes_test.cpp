/// Runs have the same bytes on CPUs with other instructions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// glibc's variants of the elementary functions for CPUs without FMA.
constexpr const char* kWithoutFma =
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA";

/// Runs a scenario into `folder/name` and returns what a clock did not measure.
std::vector<std::string> play(const fs::path& folder, const std::string& name,
                              const std::string& scenario, const std::string& environment) {
  const Outcome run =
      castaway(folder, fmt::format("run {} --set outputs.snapshots=false --out {}", scenario, name),
               environment);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::vector<std::string> files;
  for (const char* file :
       {"truth.tum", "mh_amcl.tum", "errors.csv", "events.csv", "summary.json"}) {
    files.push_back(text_of(folder / name / file));
  }
  return files;
}

TEST(SameBytes, WithoutFma) {
  const fs::path folder = fresh_folder();
  for (const std::string scenario : {"lab/kidnap --duration 60", "office/people --duration 3"}) {
    EXPECT_EQ(play(folder, "plain", scenario, ""), play(folder, "masked", scenario, kWithoutFma));
  }
}

TEST(SameBytes, OnAnOldCpu) {
  if (std::system("command -v qemu-x86_64 >/dev/null") != 0) GTEST_SKIP() << "no qemu-user";
  const fs::path folder = fresh_folder();
  const std::string scenario = "lab/kidnap --duration 45";
  EXPECT_EQ(play(folder, "plain", scenario, ""),
            play(folder, "old", scenario, "qemu-x86_64 -cpu Nehalem"));
}

}  // namespace
}  // namespace castaway::test
