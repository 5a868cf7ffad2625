#include "tools/pages/run/report.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/page_plots.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/outputs/sinks/errors_sink.hpp"
#include "tools/outputs/sinks/summary_sink.hpp"
#include "tools/outputs/sinks/timing_sink.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

const std::vector<std::string> kReported{"a", "<b>x</b>"};

/// A map of 3 x 2 cells of 1 m.
RosMap reported_map() {
  RosMap map;
  map.width = 3;
  map.height = 2;
  map.resolution = 1.0;
  map.cells = {0, 100, -1, 0, 0, 0};
  return map;
}

/// One record per second, with a kidnap at 4.5 s that moves truth and estimates by 4 m.
std::vector<ScanRecord> records(int count) {
  std::vector<ScanRecord> all;
  for (int t = 0; t < count; ++t) {
    ScanRecord& record = all.emplace_back(record_at(t, kReported));
    if (t < 5) continue;
    record.true_pose->T_map_base.y += 4.0;
    for (auto& localizer : record.localizers) localizer.estimate->T_map_base.y += 4.0;
  }
  return all;
}

/// Writes a run of these records and returns its report.
std::string report_of(const std::vector<ScanRecord>& all, RunInfo info = run_of(kReported),
                      double wall_s = 1.0, const std::optional<RosMap>& map = reported_map(),
                      double end_s = 20.0, const std::string& settings = "",
                      const LevelMaps& levels = {}) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<ErrorsSink>(folder.path(), info));
  sinks.push_back(std::make_unique<SummarySink>(folder.path(), info));
  sinks.push_back(std::make_unique<TimingSink>(folder.path(), info));
  for (auto& sink : sinks) {
    sink->on_event(kidnap_to(4.5));
    for (const ScanRecord& record : all) sink->on_scan(record);
    sink->finish(localization::from_seconds(end_s), {wall_s, {{"lidar", 0.1 * wall_s}}});
  }
  if (!settings.empty()) folder.put("scenario.yaml", settings);
  folder.put("snapshots/t0004.500-kidnap-1-map.png", "\x89PNG");
  write_report(folder.path(), {map, levels});
  return read_file(folder.path() / "report.html");
}

/// A row of the metrics table.
std::string row(const std::string& label, const std::string& a, const std::string& b) {
  return "<tr><td>" + label + "</td><td>" + a + "</td><td>" + b + "</td></tr>";
}

std::string without_timing(const std::string& html) {
  const std::size_t begin = html.find("<!-- timing: begin -->");
  const std::size_t end = html.find("<!-- timing: end -->");
  EXPECT_LT(begin, end);
  EXPECT_NE(end, std::string::npos);
  return html.substr(0, begin) + html.substr(end);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// All values of an attribute in the page.
std::vector<std::string> values_of(const std::string& attribute, const std::string& html) {
  std::vector<std::string> values;
  const std::string start = " " + attribute + "=\"";
  for (std::size_t at = html.find(start); at != std::string::npos; at = html.find(start, at + 1)) {
    const std::size_t begin = at + start.size();
    values.push_back(html.substr(begin, html.find('"', begin) - begin));
  }
  return values;
}

/// Checks that the page is complete and shows no malformed numbers.
void expect_sound(const std::string& html) {
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(html.ends_with("</body></html>\n"));
  for (const char* bad : {"nan", "-nan", "inf ", ">inf", "null", "e+"}) {
    EXPECT_EQ(without_scripts(html).find(bad), std::string::npos) << bad;
  }
}

TEST(Report, NeedsNothingButItself) {
  const std::string html = report_of(records(20));
  EXPECT_EQ(html.find("http://"), std::string::npos);
  EXPECT_EQ(html.find("https://"), std::string::npos);
  EXPECT_EQ(html.find("url("), std::string::npos);
  std::size_t embedded = 0;
  for (const char* attribute : {"src", "href"}) {
    for (const std::string& value : values_of(attribute, without_scripts(html))) {
      EXPECT_TRUE(value.starts_with("data:image/png;base64,")) << value;
      ++embedded;
    }
  }
  EXPECT_EQ(embedded, 3U);  // a map for each localizer and a picture
}

TEST(Report, DescribesTheCurvesOfARunWithoutARecording) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  std::vector<ScanRecord> all = records(6);
  all[1].localizers[1].estimate.reset();
  const auto plots = plots_in(report_of(all));
  ASSERT_EQ(plots.size(), 5U);  // besides two of the stated probability
  EXPECT_EQ(plots[0].dump(),
            R"({"title":"Position error","unit":"m","y":{"log":[0.001,100]},"series":[)"
            R"({"name":"a","y":[0.2,0.2,0.2,0.2,0.2,0.2]},)"
            R"({"name":"<b>x</b>","y":[0.2,null,0.2,0.2,0.2,0.2]}],)"
            R"("limit":0.5,"marks":[4.5],"localizers":true,"times":[0,1,2,3,4,5]})");
  EXPECT_EQ(plots[1].at("title"), "Yaw error");
  EXPECT_EQ(plots[1].at("series")[0].at("y")[0], 5.73);  // 0.1 rad
  EXPECT_EQ(plots[2].at("series")[1].at("y")[1], nullptr);
}

TEST(Report, SaysHowToRepeatTheRunAndWhatWasExpected) {
  const std::string html = report_of(
      records(20), run_of(kReported), 1.0, reported_map(), 20.0,
      "name: '<i>'\nexpect:\n  a.position_error_m.mean: < 0.5\n"
      "  a.recovery.success: {is: \">= 2\", for: all seeds}\n  distance_m: {is: < 9, for: mean}\n"
      "  timing.wall_s: < 100\n");
  EXPECT_TRUE(contains(html, "castaway run scenario.yaml --out again"));
  EXPECT_TRUE(contains(html, "name: &#39;&lt;i&gt;&#39;"));
  EXPECT_TRUE(contains(html, "<td>a.position_error_m.mean</td><td>&lt; 0.5</td>"));
  EXPECT_TRUE(contains(html, "<td>met</td>"));
  EXPECT_TRUE(contains(html, "<td><strong>not met</strong></td>"));
  EXPECT_TRUE(contains(html, "(mean of the seeds)"));
  EXPECT_EQ(html.find("<td>timing.wall_s"), std::string::npos);
  const std::string replay = report_of(records(20), run_of(kReported), 1.0, reported_map(), 20.0,
                                       "log: a.log\nmap: m.yaml\n");
  EXPECT_TRUE(contains(replay, "castaway replay scenario.yaml --out again"));
  EXPECT_EQ(report_of(records(20)).find("Repeat it"), std::string::npos);
}

TEST(Report, EscapesEveryText) {
  RunInfo info = run_of(kReported);
  info.scenario = "<i>'s\" & co";
  info.world = "<u>";
  const std::string html = report_of(records(20), info);
  EXPECT_EQ(html.find("<b>x"), std::string::npos);
  EXPECT_EQ(html.find("<i>"), std::string::npos);
  EXPECT_EQ(html.find("<u>"), std::string::npos);
  EXPECT_TRUE(contains(html, "<strong>&lt;b&gt;x&lt;/b&gt;</strong>"));
  EXPECT_TRUE(contains(html, "<h1>&lt;i&gt;&#39;s&quot; &amp; co</h1>"));
}

TEST(Report, ShowsTheFiguresOfTheSummary) {
  std::vector<ScanRecord> all = records(20);
  for (ScanRecord& record : all) {
    if (record.stamp >= std::chrono::seconds(5)) record.localizers[1].estimate.reset();
  }
  const std::string html = report_of(all);
  expect_sound(html);
  EXPECT_TRUE(contains(html, row("mean", "0.200 m", "0.200 m")));
  EXPECT_TRUE(contains(html, row("95 % below", "5.73 °", "5.73 °")));
  EXPECT_TRUE(contains(html, row("time, largest", "0.600 s", "–")));
  EXPECT_TRUE(contains(html, row("Brier score", "0.250", "0.250")));  // the stated probability is
                                                                      // always 0.5
  EXPECT_TRUE(contains(html, "<strong>a</strong> recovered from 1 of 1 kidnap, after 0.600 s."));
  EXPECT_TRUE(contains(html, "1.90 m driven in 20.0 s, 1 kidnap, no collision."));
}

TEST(Report, SaysHowTheRunIsOtherwiseThanWhatItSimulates) {
  RunInfo info = run_of(kReported);
  info.notes = {"its wheels are <round>"};
  EXPECT_TRUE(contains(report_of(records(20), info), "Note: its wheels are &lt;round&gt;."));
}

TEST(Report, SaysWhichKidnapsAreNotScored) {
  const std::string late = report_of(records(20), run_of(kReported), 1.0, reported_map(), 9.0);
  EXPECT_TRUE(contains(late,
                       "<strong>a</strong> was displaced. 1 kidnap is not scored: less than 5 s "
                       "before the next one, an operator's order, or the end of the run. While"));
  EXPECT_EQ(late.find("never displaced"), std::string::npos);
  EXPECT_EQ(report_of(records(20)).find("not scored"), std::string::npos);
}

TEST(Report, ShowsCountsAsWholeNumbers) {
  std::vector<ScanRecord> all = records(20);
  for (ScanRecord& record : all) {
    if (record.stamp >= std::chrono::seconds(5)) record.localizers[1].estimate.reset();
  }
  const std::string html = report_of(all);
  EXPECT_TRUE(contains(html, row("recovered", "1 of 1", "0 of 1")));
  EXPECT_TRUE(contains(html, row("kidnaps not noticed", "0", "1")));
  EXPECT_EQ(html.find("<td>of</td>"), std::string::npos);
}

TEST(Report, IsTheSameForTheSameRunOutsideOfItsTiming) {
  const std::string one = report_of(records(20), run_of(kReported), 1.0);
  const std::string two = report_of(records(20), run_of(kReported), 2.0);
  EXPECT_NE(one, two);
  EXPECT_EQ(without_timing(one), without_timing(two));
}

TEST(Report, DoesWithoutTruth) {
  std::vector<ScanRecord> all = records(20);
  for (ScanRecord& record : all) record.true_pose.reset();
  const std::string html = report_of(all);
  expect_sound(html);
  EXPECT_TRUE(contains(html, "The log holds no true poses, so that nothing is scored."));
  EXPECT_TRUE(contains(html, row("scans answered", "100 %", "100 %")));
  EXPECT_TRUE(contains(html, "<h2>Paths on the map</h2>"));
  EXPECT_EQ(count(html, "<path class=\"path light"), 2U);
  for (const char* scored : {"recovered", "tracking", "kidnaps not noticed", "Brier"}) {
    EXPECT_EQ(html.find(scored), std::string::npos) << scored;
  }
}

TEST(Report, DoesWithoutEstimates) {
  std::vector<ScanRecord> all = records(20);
  for (ScanRecord& record : all) {
    for (LocalizerRecord& localizer : record.localizers) localizer.estimate.reset();
  }
  expect_sound(report_of(all));
}

TEST(Report, DoesWithOneRowOrNone) {
  expect_sound(report_of(records(1)));
  const std::string html = report_of({});
  expect_sound(html);
  EXPECT_TRUE(contains(html, "There was no scan."));
  EXPECT_TRUE(contains(html, row("recovered", "–", "–")));
}

TEST(Report, DoesWithoutLocalizersAndMap) {
  expect_sound(report_of({}, run_of({}), 1.0, std::nullopt));
  expect_sound(report_of(records(20), run_of(kReported), 1.0, std::nullopt));
}

TEST(Report, DrawsPathsWithoutMapAsLargeAsTheyAre) {
  std::vector<ScanRecord> all{record_at(0.0, kReported)};
  all[0].true_pose->T_map_base.x = 1000.0;
  for (auto& localizer : all[0].localizers) localizer.estimate->T_map_base = {1000.0, 0.0, 0.0};
  // The path is a point: the plot shows 1 m around it, in cells of 5 cm.
  EXPECT_TRUE(contains(report_of(all, run_of(kReported), 1.0, std::nullopt),
                       "<svg class=\"map\" viewBox=\"0 0 40 41.1\""));
}

TEST(Report, DrawsAScaleBarBeneathTheMap) {
  const std::string html = report_of(records(12));  // 3 cells of 1 m.
  EXPECT_TRUE(contains(html, "<path class=\"scale\""));
  EXPECT_TRUE(contains(html, ">0.5 m</text></svg>"));
}

TEST(Report, DrawsPathsOnTheFloorOnWhichTheyAre) {
  std::vector<ScanRecord> all = records(4);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].true_pose->T_footprint_base.emplace(Eigen::Translation3d(0.0, 0.0, i < 2 ? 0.0 : 3.0));
    for (auto& localizer : all[i].localizers) {
      localizer.estimate->footing = {.z = i < 1 ? 0.0 : 3.0};
    }
  }
  RunInfo info = run_of(kReported);
  info.heights = true;
  const std::string html = report_of(all, info, 1.0, reported_map(), 20.0, "",
                                     {{0.0, reported_map()}, {3.0, reported_map()}});
  EXPECT_EQ(count(html, "a, level 0: 0.00 m</figcaption>"), 1U);
  EXPECT_EQ(count(html, "&lt;b&gt;x&lt;/b&gt;, level 1: 3.00 m</figcaption>"), 1U);
  const auto paths_of = [&](const std::string& style) {
    std::vector<std::string> paths;
    const std::string start = "<path class=\"" + style;
    for (std::size_t at = html.find(start); at != std::string::npos;
         at = html.find(start, at + 1)) {
      const std::size_t begin = html.find(" d=\"", at) + 4;
      paths.push_back(html.substr(begin, html.find('"', begin) - begin));
    }
    return paths;
  };
  const std::vector<std::string> rims = paths_of("path rim");  // Of each localizer and floor.
  const std::vector<std::string> estimates = paths_of("path light");
  ASSERT_EQ(rims.size(), 4U);
  EXPECT_EQ(count(rims[0], "L"), 1U);  // The truth: two scans on each floor.
  EXPECT_EQ(count(rims[2], "L"), 1U);
  ASSERT_EQ(estimates.size(), 4U);
  EXPECT_EQ(count(estimates[0], "L"),
            0U);  // An estimate: one on the lower, three on the upper one.
  EXPECT_EQ(count(estimates[2], "L"), 2U);
}

/// Twelve scans, in the first six of which the error of "a" is 0.2 m, then 0.7 m.
TEST(Report, ColoursTheTruePathByTheError) {
  std::vector<ScanRecord> all;
  for (int t = 0; t < 12; ++t) {
    ScanRecord& record = all.emplace_back(record_at(t, kReported));
    if (t >= 6) record.localizers[0].estimate->T_map_base.y = 0.7;
    if (t == 11) record.localizers[0].estimate.reset();
  }
  const std::string html = report_of(all);
  const std::size_t first = html.find("<path class=\"path e2\"");
  ASSERT_NE(first, std::string::npos);
  // Cells of 1 m, 0.1 m a scan: to 0.5 m in one colour, to 1 m in the next, then without an answer.
  EXPECT_TRUE(
      contains(html.substr(first, 200), "d=\"M0.0 2.0L0.1 2.0L0.2 2.0L0.3 2.0L0.4 2.0L0.5 2.0\""));
  EXPECT_TRUE(contains(html, "<path class=\"path e3\""));
  const std::size_t wrong = html.find("<path class=\"path e3\"");
  EXPECT_TRUE(
      contains(html.substr(wrong, 200), "d=\"M0.5 2.0L0.6 2.0L0.7 2.0L0.8 2.0L0.9 2.0L1.0 2.0\""));
  const std::size_t silent = html.find("<path class=\"path unscored\"");
  EXPECT_TRUE(contains(html.substr(silent, 200), "d=\"M1.0 2.0L1.1 2.0\""));
  EXPECT_TRUE(contains(html, "Position error [m]:"));
}

TEST(Report, MarksKidnapsAndRecoveriesOnTheMap) {
  std::vector<ScanRecord> all = records(20);
  for (ScanRecord& record : all) {
    if (record.stamp >= std::chrono::seconds(5)) record.localizers[1].estimate.reset();
  }
  const std::string html = report_of(all);
  EXPECT_EQ(count(html, "class=\"sign kidnapped\""), 2U);  // On the map of each localizer.
  EXPECT_TRUE(contains(html, "1▼<title>kidnap 1 at 4.5 s</title>"));
  EXPECT_EQ(count(html, "class=\"sign regained\""), 1U);  // "a" alone is right again.
  EXPECT_TRUE(contains(html, "✓<title>right again at 5.1 s</title>"));
}

TEST(Report, ListsTheKidnapsWithTheirOutcomes) {
  std::vector<ScanRecord> all = records(20);
  for (ScanRecord& record : all) {
    if (record.stamp >= std::chrono::seconds(5)) record.localizers[1].estimate.reset();
  }
  const std::string html = report_of(all);
  EXPECT_TRUE(
      contains(html, "<span>4.00 m</span></td><td data-head=\"a\"><span>0.600 s</span></td>"));
  EXPECT_TRUE(contains(html, "<span class=\"bad\">not recovered</span>, lost for 15.5 s"));
}

TEST(Report, SaysWhenAndWhereItWasMadeAmongItsTimesAlone) {
  const std::string html = report_of(records(20));
  EXPECT_TRUE(contains(html, "<p id=\"castaway-made\">made on 20"));
  EXPECT_TRUE(contains(html, "<span id=\"castaway-made-place\"></span>"));
  EXPECT_TRUE(contains(html, "castaway " CASTAWAY_VERSION));
  EXPECT_EQ(without_timing(html).find("castaway-made\""), std::string::npos);
}

TEST(Report, SaysTheCommitOfTheRun) {
  const TemporaryFolder folder;
  SummarySink(folder.path(), run_of(kReported)).finish(localization::from_seconds(1.0), {});
  ErrorsSink(folder.path(), run_of(kReported)).finish(localization::from_seconds(1.0), {});
  RunFolder run = load_run_folder(folder.path());
  run.timing = {{"made", {{"date", "today"}, {"machine", "here"}, {"commit", "0123<"}}}};
  EXPECT_TRUE(contains(render_report(run, {}), "made on today, here, at commit 0123&lt;</p>"));
  run.timing["made"].erase("commit");
  EXPECT_TRUE(contains(render_report(run, {}), "made on today, here</p>"));
}

TEST(Report, NamesTheFileThatIsBroken) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(error_of([&] { write_report(folder.path(), {}); }), "summary.json"));
  folder.put("summary.json", "{\"scenario\": ");
  EXPECT_TRUE(contains(error_of([&] { write_report(folder.path(), {}); }), "broken JSON"));
  folder.put("summary.json", "{}");
  EXPECT_TRUE(contains(error_of([&] { write_report(folder.path(), {}); }), "localizers"));
  folder.put("summary.json", "{\"localizers\": {}}");
  EXPECT_TRUE(contains(error_of([&] { write_report(folder.path(), {}); }), "errors.csv"));
}

TEST(Report, NamesAnEventThatItDoesNotKnow) {
  const TemporaryFolder folder;
  {
    ErrorsSink errors(folder.path());
    SummarySink summary(folder.path(), run_of(kReported));
    errors.finish({}, {});
    summary.finish({}, {});
  }
  const std::string header = read_file(folder.path() / "events.csv");
  folder.put("events.csv", header + "1.0,landing,,,,,,,,,,\n");
  const std::string error = error_of([&] { write_report(folder.path(), {}); });
  EXPECT_TRUE(contains(error, "events.csv: kind: no kind of event is called 'landing'")) << error;
}

}  // namespace
}  // namespace castaway::testbed
