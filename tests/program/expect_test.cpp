// Expectations, seeds and JUnit reports as used in CI.
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using OrderedJson = nlohmann::ordered_json;

const char* const kScenario = R"(name: gate
world: lab
duration_s: 8
physics: kinematic
lidar: {rate_hz: 5, range_max: 12}
localizers: [mh_amcl]
outputs: {snapshots: false, report: false}
expect:
  mh_amcl.position_error_m.mean: "< 0.5"
  collisions: {is: "== 0", for: max}
)";

fs::path folder_with_scenario(const std::string& more = "") {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "gate.yaml") << kScenario << more;
  return folder;
}

TEST(Expectations, ThatAreMetExitWithZero) {
  const fs::path folder = folder_with_scenario();
  const Outcome outcome = castaway(folder, "run gate.yaml --out run --junit junit.xml");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "Expectations: 2 of 2 met");
  expect_contains(text_of(folder / "junit.xml"), "tests=\"3\" failures=\"0\" errors=\"0\"");
  expect_contains(text_of(folder / "run/scenario.yaml"), "mh_amcl.position_error_m.mean");
}

TEST(Expectations, ThatAreNotMetExitWithThreeAndSayWhich) {
  const fs::path folder = folder_with_scenario("  distance_m: \"> 1000\"\n");
  const Outcome outcome = castaway(folder, "run gate.yaml --out run --junit junit.xml --json");
  EXPECT_EQ(outcome.exit_code, 3);
  expect_contains(outcome.err, "Expectations: 2 of 3 met");
  expect_contains(outcome.err, "not met: distance_m is ");
  expect_contains(outcome.err, "expected > 1000, missed by ");
  expect_contains(outcome.err, "(seed 1), see run");
  EXPECT_EQ(OrderedJson::parse(outcome.out).at("scenario"), "gate");
  expect_contains(text_of(folder / "junit.xml"), "failures=\"1\"");
}

TEST(Expectations, OfSeedsAreSummedUpInMarkdown) {
  const fs::path folder = folder_with_scenario("  distance_m: \"> 1000\"\n");
  const Outcome outcome = castaway(
      folder, "run gate.yaml --seeds 3..4 --set people.count=0 --out runs --markdown sum.md");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  const std::string page = text_of(folder / "sum.md");
  expect_contains(page, "### \xE2\x9D\x8C gate\n\n2 seeds, 0 failed; 3 of 5 expectations met.");
  expect_contains(page, "|---|---:|---:|---:|---:|---:|\n| mh_amcl | ");
  expect_contains(page, "* not met: `distance_m is ");
  expect_contains(page,
                  "To repeat seed 3: `castaway run gate.yaml --set people.count=0 --seed 3 --out "
                  "look`\n");
  EXPECT_EQ(castaway(folder, "run gate.yaml --set people.count=0 --seed 3 --out look").exit_code,
            3);
  std::ofstream(folder / "mine.md") << "mine";
  EXPECT_EQ(castaway(folder, "run gate.yaml --seeds 2 --out more --markdown mine.md").exit_code, 2);
  EXPECT_EQ(text_of(folder / "mine.md"), "mine");
  const Outcome single = castaway(folder, "run gate.yaml --out one --markdown one.md");
  EXPECT_EQ(single.exit_code, 2);
  expect_contains(single.err, "--markdown: sums up several seeds; say which with --seeds");
}

TEST(Expectations, OfTheCommandLineAreJudgedToo) {
  const fs::path folder = folder_with_scenario();
  const Outcome outcome = castaway(
      folder, "run gate.yaml --out run --expect 'timing.localizers.mh_amcl.update_ms.mean < 0'");
  EXPECT_EQ(outcome.exit_code, 3);
  expect_contains(outcome.out, "Expectations: 2 of 3 met");
}

TEST(Expectations, OfUnknownMetricsAreRefusedBeforeTheRun) {
  const fs::path folder = folder_with_scenario();
  const Outcome outcome = castaway(folder, "run gate.yaml --out run --expect 'colisions == 0'");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "unknown metric 'colisions'; did you mean 'collisions'?");
  EXPECT_FALSE(fs::exists(folder / "run"));
}

TEST(Seeds, LeaveTheSameBytesWhateverTheNumberOfWorkers) {
  const fs::path folder = folder_with_scenario();
  for (const char* workers : {"1", "3"}) {
    const Outcome outcome = castaway(
        folder, std::string("run gate.yaml --seeds 4..6 -j ") + workers + " --out w" + workers);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_contains(outcome.out, "gate: 3 seeds, 0 failed");
    expect_contains(outcome.out, "Expectations: 4 of 4 met");  // one per seed, one for all
    EXPECT_EQ(outcome.err, "");
  }
  for (const char* file :
       {"summary.json", "seed-4/summary.json", "seed-5/errors.csv", "seed-6/truth.tum"}) {
    EXPECT_FALSE(text_of(folder / "w1" / file).empty()) << file;
    EXPECT_EQ(text_of(folder / "w1" / file), text_of(folder / "w3" / file)) << file;
  }
  const OrderedJson summary = OrderedJson::parse(text_of(folder / "w1/summary.json"));
  EXPECT_EQ(summary.at("kind"), "seeds");
  EXPECT_EQ(summary.at("seeds"), OrderedJson({4, 5, 6}));
  EXPECT_EQ(summary.at("figures").at("distance_m").at("runs"), 3);
}

TEST(Seeds, ThatMakeNoSenseAreRefused) {
  const fs::path folder = folder_with_scenario();
  const Outcome outcome = castaway(folder, "run gate.yaml --seeds 5..4");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "--seeds '5..4': give a number of seeds");
}

}  // namespace
}  // namespace castaway::test
