// Small versions of the paper's experiments, comparisons, and the scenario keys that they use.
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using OrderedJson = nlohmann::ordered_json;

class QuickExperiments : public testing::TestWithParam<int> {};

TEST_P(QuickExperiments, LeaveTheSameBytesWhateverTheNumberOfWorkers) {
  const fs::path folder = fresh_folder();
  for (const char* workers : {"1", "3"}) {
    const Outcome outcome = castaway(folder, "experiment " + std::to_string(GetParam()) +
                                                 " --quick -j " + workers + " --out w" + workers);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    expect_contains(outcome.out, "paper: MH-AMCL");
    expect_contains(outcome.out, "0 failed");
  }
  for (const char* file : {"summary.json", "runs.csv"}) {
    EXPECT_FALSE(text_of(folder / "w1" / file).empty()) << file;
    EXPECT_EQ(text_of(folder / "w1" / file), text_of(folder / "w3" / file)) << file;
  }
  EXPECT_GT(fs::file_size(folder / "w1/report.html"), 5000U);
  EXPECT_EQ(OrderedJson::parse(text_of(folder / "w1/summary.json")).at("experiment"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, QuickExperiments, testing::Values(1, 2, 3));

TEST(Experiment, RefusesAnotherNumber) {
  const Outcome outcome = castaway(fresh_folder(), "experiment 4");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "there is no experiment 4; give 1, 2 or 3");
}

TEST(Compare, PairsSeedsAndSaysWhatDiffers) {
  const fs::path folder = fresh_folder();
  const std::string run =
      "run --seeds 2 --duration 6 --set physics=kinematic --set events=~ --set "
      "outputs.snapshots=false --set outputs.report=false ";
  ASSERT_EQ(castaway(folder, run + "--out before").exit_code, 0);
  ASSERT_EQ(castaway(folder, run + "--out after --set lidar.beams=40").exit_code, 0);
  ASSERT_EQ(castaway(folder, run + "--out again").exit_code, 0);
  const Outcome outcome = castaway(folder, "compare before again --out page");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "again against before: 2 pairs, 0 runs without a counterpart");
  expect_contains(outcome.out, "mh_amcl.position_error_m.mean");
  EXPECT_TRUE(fs::exists(folder / "page/comparison.html"));
  const Outcome refused = castaway(folder, "compare before after --json");
  EXPECT_EQ(refused.exit_code, 2);
  expect_contains(refused.err, "not comparable: 'lidar' differs between before/seed-1");
}

TEST(Run, EndsAfterAWayAndBeginsOnTheMove) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder,
               "run --out run --duration 60 --set stop_after_m=2 --set 'start={random: true, "
               "known: false, switch_on_s: 3}' --set events=~ --set outputs.snapshots=false --set "
               "outputs.report=false --set drive.route=random");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const OrderedJson summary = OrderedJson::parse(text_of(folder / "run/summary.json"));
  EXPECT_LT(summary.at("distance_m").get<double>(), 2.0);  // without the first 3 s
  EXPECT_LT(summary.at("duration_s").get<double>(), 30.0);
  const std::string truth = text_of(folder / "run/truth.tum");
  EXPECT_GE(std::stod(truth), 3.0);
  const Outcome late = castaway(
      folder, "run --duration 3 --set 'start={random: true, known: false, switch_on_s: 3}'");
  EXPECT_EQ(late.exit_code, 2);
  expect_contains(late.err, "'start.switch_on_s' must be less than 'duration_s'");
  const Outcome known = castaway(folder, "run --set start.switch_on_s=3");
  EXPECT_EQ(known.exit_code, 2);
  expect_contains(known.err, "'switch_on_s' needs 'known: false'");
}

TEST(Experiment, TakesALocalizerOfTheUsersAlong) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(
      folder,
      "experiment 2 --quick --out out --localizer amcl:amcl-prob --localizer \"program:python3 " +
          std::string(CASTAWAY_SOURCE_DIR) + "/examples/program/dead_reckoning.py\"");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "dead_reckoning");
  expect_contains(outcome.out, "amcl-prob");
  expect_contains(text_of(folder / "out/runs.csv"), "dead_reckoning");
}

}  // namespace
}  // namespace castaway::test
