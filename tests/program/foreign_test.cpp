// Tests localizers of the user's: programs and shared libraries.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const std::string kExamples = std::string(CASTAWAY_SOURCE_DIR) + "/examples/";
constexpr const char* kBrief =
    "run --duration 4 --set outputs.snapshots=false --set outputs.report=false --out run ";

Json summary_of(const fs::path& folder) {
  return Json::parse(text_of(folder / "run/summary.json"));
}

/// Runs with these localizers and returns their trajectories' texts.
std::string trajectory(const fs::path& folder, const std::string& localizer,
                       const std::string& name) {
  fs::remove_all(folder / "run");
  const Outcome outcome = castaway(folder, kBrief + ("--localizer \"" + localizer + "\""));
  EXPECT_EQ(outcome.exit_code, 0) << localizer << ": " << outcome.err;
  EXPECT_EQ(outcome.err, "") << localizer;
  return text_of(folder / "run" / (name + ".tum"));
}

TEST(ForeignLocalizer, DeadReckoningIsTheSameInEveryWay) {
  const fs::path folder = fresh_folder();
  const std::string python = trajectory(
      folder, "program:python3 " + kExamples + "program/dead_reckoning.py", "dead_reckoning");
  EXPECT_GT(std::count(python.begin(), python.end(), '\n'), 30);
  EXPECT_EQ(
      trajectory(folder, "program:" + kExamples + "program/dead_reckoning.sh", "dead_reckoning"),
      python);
  EXPECT_EQ(trajectory(folder, "library:" CASTAWAY_DEAD_RECKONING, "dead_reckoning"), python);
  EXPECT_EQ(
      trajectory(folder, "program:" CASTAWAY_PROGRAM " serve library:" CASTAWAY_DEAD_RECKONING,
                 "castaway"),
      python);
}

TEST(ForeignLocalizer, MhAmclIsTheSameInEveryWay) {
  const fs::path folder = fresh_folder();
  const std::string ours = trajectory(folder, "mh_amcl", "mh_amcl");
  EXPECT_EQ(trajectory(folder, "library:" CASTAWAY_MH_AMCL, "mh_amcl"), ours);
  fs::remove_all(folder / "run");
  const Outcome outcome =
      castaway(folder, kBrief + std::string("--set 'localizers=[{name: mh_amcl, program: "
                                            "[" CASTAWAY_PROGRAM ", serve, mh_amcl]}]'"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(text_of(folder / "run/mh_amcl.tum"), ours);
}

/// Others' localizers: they track, and the one that draws particles anywhere comes back.
TEST(ForeignLocalizer, MrptTracks) {
#ifndef CASTAWAY_MRPT
  GTEST_SKIP() << "MRPT is not installed (apt-get install libmrpt-slam-dev)";
#else
  const fs::path folder = fresh_folder();
  (void)trajectory(folder, "library:" CASTAWAY_MRPT, "mrpt");
  EXPECT_LT(summary_of(folder).at("localizers").at("mrpt").at("tracking_error_m").at("mean"), 0.05);
#endif
}

TEST(ForeignLocalizer, AFilterInNumpyTracks) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << "needs python3-numpy";
  const fs::path folder = fresh_folder();
  (void)trajectory(folder, "program:" + python + " " + kExamples + "program/particle_filter.py",
                   "particle_filter");
  const Json figures = summary_of(folder).at("localizers").at("particle_filter");
  EXPECT_LT(figures.at("tracking_error_m").at("mean"), 0.15);
  EXPECT_LT(figures.at("calibration").at("brier"), 0.2);
}

TEST(ForeignLocalizer, IsTimedAndLogged) {
  const fs::path folder = fresh_folder();
  write(folder / "mine.py",
        "import sys\nprint('hello from mine', file=sys.stderr)\n"
        "sys.path.insert(0, '" +
            kExamples + "program')\nimport dead_reckoning\n");
  const Outcome outcome =
      castaway(folder, kBrief + std::string("--localizer 'program:python3 mine.py'"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(text_of(folder / "run/mine.log"), "hello from mine\n");
  const Json timing = Json::parse(text_of(folder / "run/timing.json")).at("localizers").at("mine");
  EXPECT_GT(timing.at("outside").at("peak_memory_mb"), 3.0);
  EXPECT_GT(timing.at("outside").at("cpu_s"), 0.005);
  EXPECT_GT(timing.at("update_ms").at("max"), 1.0);  // Python starts.
  const Json figures = summary_of(folder).at("localizers").at("mine");
  EXPECT_TRUE(figures.at("calibration").at("brier").is_null());  // It states no probability.
}

TEST(ForeignLocalizer, GetsItsParameters) {
  const fs::path folder = fresh_folder();
  write(folder / "mine.sh", "head -1 | grep -o '\"params\":.*' >&2\n");
  write(folder / "s.yaml",
        "world: lab\nlocalizers:\n  - {name: mine, program: [sh, mine.sh], params: {a: 1.5, b: [x, "
        "true]}}\n  - amcl\n");
  const Outcome outcome =
      castaway(folder, "run s.yaml --allow-programs --duration 2 --out run --json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "castaway: localizer 'mine' exited with 0; the run went on without it\n");
  EXPECT_EQ(text_of(folder / "run/mine.log"), "\"params\":{\"a\":1.5,\"b\":[\"x\",true]}}\n");
  EXPECT_EQ(summary_of(folder).at("failed").at("mine").at("what"), "exited with 0");
  expect_contains(text_of(folder / "run/events.csv"), "localizer failed,exited with 0,mine");
  expect_contains(text_of(folder / "run/report.html"), "mine failed at");
  expect_contains(text_of(folder / "run/scenario.yaml"), "mine.sh");
}

TEST(ForeignLocalizer, IsFoundBesideItsScenario) {
  const fs::path folder = fresh_folder();
  write(folder / "there/mine.sh", "exit 7\n");
  write(folder / "there/s.yaml", "localizers: [{name: mine, program: sh mine.sh}]\n");
  const Outcome outcome =
      castaway(folder, "run there/s.yaml --allow-programs --duration 1 --out run");
  expect_contains(outcome.err, "exited with 7");
}

TEST(ForeignLocalizer, IsNotStartedByAFileWithoutTrust) {
  const fs::path folder = fresh_folder();
  write(folder / "s.yaml", "localizers:\n  - {name: mine, program: [touch, started]}\n");
  write(folder / "l.yaml", "localizers:\n  - {name: mine, library: ./libmine.so}\n");
  write(folder / "d.yaml",
        "scenario: {localizers: [{name: mine, program: [touch, started]}]}\nsplits: {}\n");
  expect_refused(castaway(folder, "run s.yaml --out run"),
                 {"s.yaml:2",
                  "localizers[0].program: this file starts a program; add "
                  "--allow-programs if you trust it"});
  expect_refused(castaway(folder, "run s.yaml --seeds 2 --out run"), {"--allow-programs"});
  expect_refused(castaway(folder, "run s.yaml --set localizers.0.name=x --out run"),
                 {"--allow-programs"});
  expect_refused(castaway(folder, "bench kidnaps --localizer l.yaml"),
                 {"l.yaml:2", "this file loads a library"});
  expect_refused(castaway(folder, "check-world lab --scenario s.yaml"), {"--allow-programs"});
  EXPECT_FALSE(fs::exists(folder / "started"));
}

TEST(ForeignLocalizer, BadOnesAreRefusedInOneLine) {
  const fs::path folder = fresh_folder();
  const auto refused = [&](const std::string& localizer, const std::vector<std::string>& parts) {
    const Outcome outcome = castaway(folder, kBrief + ("--localizer '" + localizer + "'"));
    EXPECT_EQ(outcome.exit_code, 2) << localizer;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const std::string& part : parts) expect_contains(outcome.err, part);
    EXPECT_FALSE(fs::exists(folder / "run")) << localizer;
  };
  refused("program:", {"needs a command"});
  refused("library:", {"needs a file"});
  refused("program:nosuchprogram", {"localizer 'nosuchprogram'", "No such file or directory"});
  refused("program:python3 \"mine.py", {"a quote has no end"});
  refused("library:./libnone.so", {"localizer 'none'", "cannot load the library", "libnone.so"});
  write(folder / "libtext.so", "no library\n");
  refused("library:libtext.so", {"cannot load the library", "libtext.so"});
  refused("library:" CASTAWAY_OLD_PLUGIN, {"has version 0 of the interface", "version 1"});
  refused("library:" CASTAWAY_NO_PLUGIN, {"has no function castaway_localizer"});
  refused("library:" CASTAWAY_BAD_PLUGIN, {"no map to my taste"});
  refused("programm:x", {"unknown localizer", "program"});
}

TEST(ForeignLocalizer, AnExceptionOfALibraryEndsItsRunOnly) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(
      folder, kBrief + std::string("--localizer amcl --set 'localizers=[amcl, {name: bad, library: "
                                   "'" CASTAWAY_BAD_PLUGIN "', params: {until: 3}}]'"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "castaway: localizer 'bad' lost its patience; the run went on without it\n");
  EXPECT_GT(summary_of(folder).at("failed").at("bad").at("at_s"), 0.2);
}

/// A gate must not take it for a run that met its expectations.
TEST(ForeignLocalizer, ALibraryThatEndsTheProgramFailsTheRun) {
  const fs::path folder = fresh_folder();
  for (const char* how : {"exit", "now"}) {
    const Outcome outcome =
        castaway(folder, kBrief +
                             std::string("--set 'localizers=[amcl, {name: bad, library: "
                                         "'" CASTAWAY_BAD_PLUGIN "', params: {leave: ") +
                             how + "}}]'");
    EXPECT_EQ(outcome.exit_code, 1) << how;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    expect_contains(outcome.err, "a library that it loaded ended the program");
  }
}

TEST(ForeignLocalizer, ALibraryThatIsCutOffIsRefused) {
  const fs::path folder = fresh_folder();
  const std::string whole = text_of(CASTAWAY_BAD_PLUGIN);
  for (const std::size_t part : {2U, 4U, 8U}) {
    write(folder / "libcut.so", whole.substr(0, whole.size() / part));
    expect_refused(castaway(folder, kBrief + std::string("--localizer library:libcut.so")),
                   {"localizer 'cut'"});
  }
}

TEST(ForeignLocalizer, EndsWithARunThatIsKilled) {
  const fs::path folder = fresh_folder();
  write(folder / "mine.sh",
        "echo $$ > pid\nsetsid sh -c 'echo $$ > pid2; exec sleep 1000' &\n"
        "exec python3 " +
            kExamples + "program/dead_reckoning.py\n");
  const std::string command = "cd '" + folder.string() +
                              "' && { '" CASTAWAY_PROGRAM
                              "' run --duration 10000 --localizer 'program:sh mine.sh' --out run "
                              ">/dev/null 2>&1 & echo $! > castaway; }";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto until = [](auto holds) {
    for (int i = 0; i < 200 && !holds(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return holds();
  };
  const auto number = [&](const char* file) { return std::atoi(text_of(folder / file).c_str()); };
  const auto runs = [&](const char* file) {
    return fs::exists("/proc/" + std::to_string(number(file)));
  };
  ASSERT_TRUE(until([&] { return number("pid") > 0 && number("pid2") > 0; }));
  EXPECT_TRUE(runs("pid"));
  EXPECT_TRUE(runs("pid2"));
  ASSERT_EQ(std::system(("kill -9 " + std::to_string(number("castaway"))).c_str()), 0);
  EXPECT_TRUE(until([&] { return !runs("pid") && !runs("pid2"); }));
}

TEST(ForeignLocalizer, IsEvaluatedAndBenchedLikeOurs) {
  const fs::path folder = fresh_folder();
  const Outcome bench =
      castaway(folder, "bench kidnaps --kidnaps 2 --json --localizer \"program:python3 " +
                           kExamples + "program/dead_reckoning.py\"");
  ASSERT_EQ(bench.exit_code, 0) << bench.err;
  expect_contains(bench.out, "dead_reckoning");
  const Outcome failing =
      castaway(folder, "bench kidnaps --kidnaps 2 --localizer 'program:sh -c \"exit 4\"'");
  EXPECT_EQ(failing.exit_code, 1);
  expect_contains(failing.err, "localizer 'sh' exited with 4");
}

}  // namespace
}  // namespace castaway::test
