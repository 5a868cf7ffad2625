#include "tools/twin/prediction/predict_logs.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/pages/twin/calibration_page.hpp"
#include "tools/pages/twin/place_picture.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

PredictionConfig short_prediction() {
  PredictionConfig config;
  config.pages = {render_calibration, place_picture};
  config.evaluation.starts = 2;
  config.evaluation.kidnaps = 1;
  config.evaluation.window_s = 4.0;
  config.evaluation.scans_before_kidnap = 10;
  config.align = AlignBy::kTruth;
  return config;
}

TEST(PredictLogs, WritesATwinForEachLogAndEvaluatesBoth) {
  const TemporaryFolder folder;
  write_office(recorded_office(120), folder.path() / "first");
  write_office(recorded_office(100), folder.path() / "second");
  const std::filesystem::path out = folder.path() / "out";
  const auto localizers = parse_localizers({"mh_amcl", "amcl"});
  const auto predict_with = [&](int workers) {
    return predict_logs({(folder.path() / "first").string(), (folder.path() / "second/").string()},
                        localizers, short_prediction(), out, run_at_once(workers));
  };
  const std::vector<LogPrediction> all = predict_with(1);
  ASSERT_EQ(all.size(), 2U);
  for (const std::size_t k : {0U, 1U}) {
    const std::string name = k == 0 ? "first" : "second";
    ASSERT_EQ(all[k].rows.size(), 2U);
    EXPECT_EQ(all[k].rows[0].log.log, name);
    EXPECT_EQ(all[k].rows[1].log.localizer, "amcl");
    EXPECT_EQ(all[k].rows[0].trials.size(), 3U);
    for (const char* file : {"scenario.yaml", "map.yaml", "world.yaml", "path.tum",
                             "scan_times.txt", "calibration.json", "calibration.html"}) {
      EXPECT_TRUE(std::filesystem::exists(out / name / file)) << file;
    }
  }
  const std::vector<LogPrediction> at_once = predict_with(2);
  for (const std::size_t k : {0U, 1U}) {
    for (const std::size_t l : {0U, 1U}) {
      EXPECT_EQ(at_once[k].rows[l].log.starts.time_s, all[k].rows[l].log.starts.time_s);
      EXPECT_EQ(at_once[k].rows[l].twin.starts.time_s, all[k].rows[l].twin.starts.time_s);
      EXPECT_EQ(at_once[k].rows[l].twin.tracking_m, all[k].rows[l].twin.tracking_m);
    }
  }
}

TEST(PredictLogs, ShowsPlacesWhereLogAndTwinDiffer) {
  // In the middle of the log, the lidar saw nothing; that of the twin does.
  RecordedPlace place = recorded_office(120);
  SE2 T_map_base;
  int index = 0;
  for (Frame& frame : place.frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr) continue;
    const int k = index++;
    if (k == 40) T_map_base = scan->true_pose->T_map_base;
    if (k >= 30 && k < 70) scan->scan.ranges.assign(scan->scan.ranges.size(), 12.0F);
  }
  const TemporaryFolder folder;
  write_office(place, folder.path() / "office");
  PredictionConfig config = short_prediction();
  config.evaluation.kidnaps = 0;
  const auto all =
      predict_logs({(folder.path() / "office").string()}, parse_localizers({"mh_amcl"}), config,
                   folder.path() / "out", run_at_once(1));
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].places.size(), 1U);
  const DifferingPlace& found = all[0].places[0];
  EXPECT_EQ(found.log, "office");
  EXPECT_FALSE(found.kidnap);
  EXPECT_EQ(found.index, 1);  // of the two starts, at scans 0 and 40
  EXPECT_EQ(found.apart, 1.0);
  EXPECT_EQ(found.localizers, std::vector<std::string>{"mh_amcl"});
  EXPECT_LT(localization::distance(found.T_map_base, T_map_base), 0.05);
  EXPECT_TRUE(contains(found.picture, "<g style=\"fill:#d0103a\"></g>"));     // the log's scan
  EXPECT_TRUE(contains(found.picture, "<g style=\"fill:#0072B2\"><circle"));  // the twin's
}

TEST(PredictLogs, NamesLogsOfOneNameAndThoseThatAreMissing) {
  const TemporaryFolder folder;
  const auto error = [&](const std::vector<std::string>& logs) {
    return error_of([&] {
      predict_logs(logs, parse_localizers({"amcl"}), short_prediction(), folder.path() / "out",
                   run_at_once(1));
    });
  };
  EXPECT_TRUE(contains(error({"/a/hall", "/b/hall/"}),
                       "/b/hall/: two logs are in folders named 'hall'; rename one"));
  EXPECT_TRUE(contains(error({"/nowhere/hall"}), "/nowhere/hall: "));
}

}  // namespace
}  // namespace castaway::testbed
