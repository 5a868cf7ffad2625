// Tests that no program, whatever it does, hangs a run or costs it what was written.
#include <chrono>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

/// A program and what castaway says of it.
struct Hostile {
  const char* name;
  const char* script;  ///< For sh.
  const char* said;    ///< Part of the line on stderr.
};

/// Answers `hello` and $1 scans, then goes on with the rest of the script.
constexpr const char* kBegin = R"(
answer() {
  while read -r line; do
    case $line in
      *'"type":"hello"'*) echo '{"type":"ready"}' ;;
      *'"type":"scan"'*)
        [ "$1" -gt 0 ] || return 0
        set -- $(($1 - 1))
        stamp=${line#*stamp_ns\":}
        echo "{\"type\":\"estimate\",\"stamp_ns\":${stamp%%,*},\"pose\":[1,2,0]}" ;;
      *'"type":"bye"'*) exit 0 ;;
    esac
  done
}
)";

class HostileProgram : public testing::TestWithParam<Hostile> {};

TEST_P(HostileProgram, EndsInOneLineAndNothingIsLost) {
  const Hostile& hostile = GetParam();
  const fs::path folder = fresh_folder();
  write(folder / "mine.sh", std::string(kBegin) + hostile.script + "\n");
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome =
      castaway(folder,
               "run --duration 3 --out run --set outputs.snapshots=false --set 'localizers=[amcl, "
               "{name: mine, program: [sh, mine.sh], timeout_s: 1, start_timeout_s: 2}]'");
  const auto took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took, std::chrono::seconds(60));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  expect_contains(outcome.err, "castaway: localizer 'mine' ");
  expect_contains(outcome.err, hostile.said);
  const Json summary = Json::parse(text_of(folder / "run/summary.json"));
  EXPECT_TRUE(summary.at("failed").contains("mine"));
  EXPECT_FALSE(summary.at("failed").contains("amcl"));
  EXPECT_GT(summary.at("localizers").at("amcl").at("availability"), 0.9);
  expect_contains(text_of(folder / "run/events.csv"), "localizer failed");
  EXPECT_TRUE(fs::exists(folder / "run/report.html"));
}

INSTANTIATE_TEST_SUITE_P(
    All, HostileProgram,
    testing::Values(
        Hostile{"floods", "yes", "answer"},
        Hostile{"floods_later", "answer 3; yes 'x'", "not JSON"},
        Hostile{"closes_its_output", "answer 3; exec >&-; sleep 1000",
                "closed its standard output"},
        Hostile{"closes_its_input", "answer 3; exec <&-; sleep 1000", "did not answer within 1 s"},
        Hostile{"sleeps", "answer 3; sleep 1000", "did not answer within 1 s"},
        Hostile{"never_gets_ready", "sleep 1000", "did not answer within 2 s"},
        Hostile{"forks",
                "answer 3; for i in 1 2 3 4 5 6 7 8; do sh -c 'setsid sleep 1000 & sleep "
                "1000' & done; exit 2",
                "exited with 2"},
        Hostile{"writes_a_megabyte_line",
                "answer 3; head -c 3000000 /dev/zero | tr '\\0' x; sleep 1000",
                "answered more than 1048576 bytes"},
        Hostile{"exits_at_once", "exit 3", "exited with 3"},
        Hostile{"exits_at_a_scan", "answer 3; exit 4", "exited with 4"},
        Hostile{"is_killed", "answer 3; kill -9 $$", "was killed by signal 9"},
        Hostile{"stops_its_parent", "answer 3; kill -STOP $PPID; sleep 1000",
                "did not answer within 1 s"},
        Hostile{"kills_its_parent", "answer 3; setsid sleep 1000 & kill -9 $PPID; sleep 1000",
                "was killed by signal 9"},
        Hostile{"writes_binary", "answer 3; head -c 1000 /dev/urandom; echo; sleep 1000",
                "not JSON"},
        Hostile{"states_nan",
                "answer 0; stamp=${line#*stamp_ns\\\":}; echo "
                "\"{\\\"type\\\":\\\"estimate\\\",\\\"stamp_ns\\\":${stamp%%,*},\\\"pose\\\":[NaN,"
                "0,0]}\""
                "; sleep 1000",
                "not JSON"},
        Hostile{"answers_another_stamp",
                "answer 0; echo '{\"type\":\"estimate\",\"stamp_ns\":1}'; sleep 1000",
                "answered for stamp '1'"}),
    [](const auto& test) { return std::string(test.param.name); });

/// A program that floods its standard error fills no disk.
TEST(HostileProgram, ALongLogIsCut) {
  const fs::path folder = fresh_folder();
  write(folder / "mine.sh",
        std::string(kBegin) + "head -c 30000000 /dev/zero >&2; answer 100000\n");
  const Outcome outcome =
      castaway(folder,
               "run --duration 2 --out run --localizer 'program:sh mine.sh' --set "
               "outputs.snapshots=false");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(fs::file_size(folder / "run/mine.log"), 16U * 1024U * 1024U);
}

}  // namespace
}  // namespace castaway::test
