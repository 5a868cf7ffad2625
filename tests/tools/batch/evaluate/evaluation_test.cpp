#include "tools/batch/evaluate/evaluation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

/// Two starts and a kidnap, 8 s each.
EvaluationConfig few() {
  EvaluationConfig config;
  config.starts = 2;
  config.kidnaps = 1;
  config.window_s = 8.0;
  config.scans_before_kidnap = 10;
  config.tracking = false;
  return config;
}

/// Moves the true poses but not the robot.
void falsify(Frames& frames, const SE2& by) {
  for (Frame& frame : frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->true_pose = by * scan->true_pose->T_map_base;
    }
  }
}

TEST(Evaluation, OfMhAmclInAnOfficeIsThatItFindsItself) {
  EvaluationConfig config = few();
  config.tracking = true;
  int trials = 0;
  const EvaluationRow row =
      evaluate(recorded_office(120), parse_localizer("mh_amcl"), config, [&] { ++trials; });
  EXPECT_EQ(row.log, "office");
  EXPECT_EQ(row.localizer, "mh_amcl");
  EXPECT_EQ(trials, 4);
  EXPECT_EQ(row.starts.trials, 2);
  EXPECT_EQ(row.starts.recovered, 2);
  EXPECT_EQ(row.kidnaps.trials, 1);
  EXPECT_EQ(row.kidnaps.recovered, 1);
  ASSERT_EQ(row.starts.time_s.size(), 2U);
  EXPECT_TRUE(std::is_sorted(row.starts.time_s.begin(), row.starts.time_s.end()));
  EXPECT_LT(row.starts.time_s.back(), 8.0);
  ASSERT_TRUE(row.tracking_m);
  EXPECT_LT(*row.tracking_m, 0.1);  // two cells
  EXPECT_EQ(row.scans, 3 * 41);     // 0 to 8 s, from the kidnap on
  EXPECT_LT(row.wrong_scans, row.scans / 2);
  EXPECT_EQ(row.detection_delay_s.size(), 1U);
  EXPECT_GT(row.calibration.scans(), row.scans / 2);  // it has no answer at first
  EXPECT_LE(row.calibration.scans(), row.scans);
  EXPECT_LT(*row.calibration.brier(), 0.25);  // better than guessing
  EXPECT_GT(row.watched_s, 15.0);
  EXPECT_GE(*false_alarms_per_h(row), 0.0);
  EXPECT_GT(row.cpu_mean_ms(), 0.0);
  EXPECT_GE(row.cpu_max_ms, row.cpu_mean_ms());
}

TEST(Evaluation, CountsAnswersThatAreWrong) {
  RecordedPlace place = recorded_office(120);
  falsify(place.frames, {2.0, 0.0, 0.0});
  const EvaluationRow row = evaluate(place, parse_localizer("mh_amcl"), few());
  EXPECT_EQ(row.starts.trials, 2);
  EXPECT_EQ(row.starts.recovered, 0);
  EXPECT_TRUE(row.starts.time_s.empty());
  EXPECT_EQ(row.scans, 3 * 41);
  EXPECT_GT(row.wrong_scans, row.scans / 2);  // it found itself and raises no alarm
  EXPECT_GT(row.longest_wrong_s, 4.0);
  EXPECT_LE(row.longest_wrong_s, 8.0);
}

TEST(Evaluation, OfALogWithoutTruthIsRefused) {
  RecordedPlace place = recorded_office(60);
  for (Frame& frame : place.frames) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->true_pose.reset();
  }
  EvaluationConfig config = few();
  config.starts = 1;
  config.kidnaps = 0;
  const std::string error = error_of([&] { evaluate(place, parse_localizer("mh_amcl"), config); });
  EXPECT_TRUE(contains(error, "office: its log holds no true poses")) << error;
}

TEST(Evaluation, CountsTrialsWithTruthAlone) {
  RecordedPlace place = recorded_office(60);
  bool first = true;
  for (Frame& frame : place.frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan != nullptr && !std::exchange(first, false)) scan->true_pose.reset();
  }
  EvaluationConfig config = few();
  config.starts = 2;
  config.kidnaps = 0;
  const EvaluationRow row = evaluate(place, parse_localizer("mh_amcl"), config);
  EXPECT_EQ(row.starts.trials, 1);
}

TEST(Evaluation, OfTheSameSeedIsTheSame) {
  EvaluationConfig config = few();
  config.starts = 1;
  config.kidnaps = 0;
  config.window_s = 3.0;
  config.stress = {.blocked_share = 0.3, .odd_scans_only = true, .boxes_per_m2 = 0.05};
  const RecordedPlace place = recorded_office(60);
  const EvaluationRow one = evaluate(place, parse_localizer("mh_amcl"), config);
  const EvaluationRow two = evaluate(place, parse_localizer("mh_amcl"), config);
  EXPECT_EQ(one.starts.time_s, two.starts.time_s);
  EXPECT_EQ(one.wrong_scans, two.wrong_scans);
  EXPECT_EQ(one.scans, 8);  // half of the 16 scans in 3 s
}

TEST(Evaluation, DoesNotDependOnTheNumberOfWorkers) {
  EvaluationConfig config = few();
  config.tracking = true;
  config.kidnap_to = SpliceKind::kLookAlike;
  const RecordedPlace place = recorded_office(120);
  const auto without_times = [&](int workers) {
    config.run = run_at_once(workers);
    int trials = 0;
    EvaluationRow row = evaluate(place, parse_localizer("mh_amcl"), config, [&] { ++trials; });
    EXPECT_EQ(trials, 4);
    EXPECT_GT(row.cpu_total_ms, 0.0);
    row.cpu_total_ms = row.cpu_max_ms = 0.0;
    return pack_row(row);
  };
  EXPECT_EQ(without_times(3), without_times(1));
}

TEST(Evaluation, RefusesWhatIsOutOfRange) {
  EvaluationConfig config;
  EXPECT_NO_THROW(validate(config));
  config.window_s = 0.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.starts = -1;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.stress.blocked_share = 2.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

TEST(RecordedPlace, IsALogAndItsMap) {
  const TemporaryFolder folder;
  write_office(recorded_office(3), folder.path() / "a-place");
  const RecordedPlace place = load_recorded_place((folder.path() / "a-place/").string());
  EXPECT_EQ(place.name, "a-place");
  EXPECT_EQ(place.map.cells, office_map().cells);
  ASSERT_EQ(place.frames.size(), 6U);
  const SE2 truth = std::get<ScanFrame>(place.frames[3].data).true_pose->T_map_base;
  const SE2 same = std::get<ScanFrame>(recorded_office(3).frames[3].data).true_pose->T_map_base;
  EXPECT_LT(localization::distance(truth, same), 1e-9);
}

TEST(RecordedPlace, TakesTheOnlyYamlAndALogOfAnyName) {
  const TemporaryFolder folder;
  write_office(recorded_office(3), folder.path());
  std::filesystem::rename(folder.path() / "map.yaml", folder.path() / "office.yaml");
  std::filesystem::rename(folder.path() / "log.carmen", folder.path() / "log");
  EXPECT_EQ(load_recorded_place(folder.path().string()).frames.size(), 6U);
  folder.put("other.yaml", "");
  EXPECT_TRUE(contains(error_of([&] { load_recorded_place(folder.path().string()); }), "no map"));
}

TEST(RecordedPlace, NamesWhatIsMissing) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& name) {
    return error_of([&] { load_recorded_place((folder.path() / name).string()); });
  };
  EXPECT_TRUE(contains(error("gone"), "gone: cannot be read"));
  folder.put("empty/readme.txt", "");
  EXPECT_TRUE(contains(error("empty"), "empty: no log"));
  folder.put("mapless/a.log", "");
  EXPECT_TRUE(contains(error("mapless"), "mapless: no map"));
}

}  // namespace
}  // namespace castaway::testbed
