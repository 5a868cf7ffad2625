#include "tools/pages/runs/runs_page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/batch/compare/aggregate.hpp"
#include "tools/outputs/sinks/errors_sink.hpp"
#include "tools/outputs/sinks/summary_sink.hpp"

namespace castaway::testbed {
namespace {

/// Writes a run of three scans with these localizers and returns its folder.
std::filesystem::path run_in(const std::filesystem::path& folder,
                             const std::vector<std::string>& localizers,
                             const std::vector<std::string>& notes = {}) {
  RunInfo info = run_of(localizers);
  info.notes = notes;
  ErrorsSink errors(folder);
  SummarySink summary(folder, info);
  for (const double t : {0.0, 1.0, 2.0}) {
    errors.on_scan(record_at(t, localizers));
    summary.on_scan(record_at(t, localizers));
  }
  errors.finish(localization::from_seconds(3.0), {});
  summary.finish(localization::from_seconds(3.0), {});
  return folder;
}

TEST(RunsPage, LeadsToEveryRunByAPathOfItsOwn) {
  const TemporaryFolder folder;
  const auto one = run_in(folder.path() / "runs/a #1", {"a", "<b>"});
  const auto two = run_in(folder.path() / "runs/two", {"a"});
  const std::string html =
      render_runs_page({.folders = {one, two}, .page = folder.path() / "pages/index.html"});
  EXPECT_TRUE(contains(html, "<h1>a-scenario: 2 runs</h1>"));
  EXPECT_TRUE(contains(html, "<a href=\"../runs/a%20%231/report.html\">seed 7</a>"));
  EXPECT_TRUE(contains(html, "<a href=\"../runs/two/report.html\">"));
  EXPECT_TRUE(contains(html, "&lt;b&gt; recovered</th>"));
  EXPECT_TRUE(contains(html, "<span>0.200 m"));
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_EQ(html.find("was never displaced"), std::string::npos);  // No prose for a run.
}

TEST(RunsPage, HasTheFiguresOfTheSetsSummary) {
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> folders;
  std::vector<MetricTable> tables;
  for (const char* name : {"1", "2", "3", "4", "5"}) {
    folders.push_back(run_in(folder.path() / name, {"a"}));
    tables.push_back(metric_table(read_json(folders.back() / "summary.json")));
  }
  const auto mean = aggregate_figures(tables).at("a.tracking_error_m.mean");
  EXPECT_EQ(mean.at("mean"), 0.2);
  const std::string html = render_runs_page({.folders = folders, .page = folder.path() / "i.html"});
  EXPECT_TRUE(contains(html, "<span>0.200 m<br><small>0.200 to 0.200 m</small></span>"));
  EXPECT_TRUE(contains(html, "<span>no kidnap</span>"));
}

TEST(RunsPage, SaysNotesFailuresAndExpectationsInALineEach) {
  const TemporaryFolder folder;
  const auto one = run_in(folder.path() / "one", {"a"}, {"its wheels are <round>"});
  const auto two = run_in(folder.path() / "two", {"a"}, {"its wheels are <round>"});
  const Check check{parse_expectation("a.recovery.success >= 1"), 7, 0.5, false, "/a/folder"};
  const Check clock{parse_expectation("timing.wall_s < 1"), 7, 0.5, true, "/a/folder"};
  const std::string html = render_runs_page({.folders = {one, two},
                                             .page = folder.path() / "i.html",
                                             .failed_seeds = {9},
                                             .checks = {check, clock}});
  EXPECT_TRUE(contains(html, "<p class=\"soft\">Notes: its wheels are &lt;round&gt;.</p>"));
  EXPECT_TRUE(
      contains(html, "World a-world, robot a-robot, 3.00 s each; seeds 7, 7; failed: seed 9"));
  EXPECT_TRUE(contains(html, "Expectations: 0 of 1 met."));
  EXPECT_TRUE(contains(html, "not met: a.recovery.success &gt;= 1 (0.5; seed 7)"));
  EXPECT_EQ(html.find("/a/folder"), std::string::npos);
  EXPECT_TRUE(contains(html, "run failed"));
}

TEST(RunsPage, ShowsARunWithoutLocalizers) {
  const TemporaryFolder folder;
  const std::string html = render_runs_page(
      {.folders = {run_in(folder.path() / "none", {})}, .page = folder.path() / "index.html"});
  EXPECT_TRUE(contains(html, "There is no localizer."));
  EXPECT_TRUE(contains(html, "<h1>a-scenario: 1 run</h1>"));
}

TEST(RunsPage, NamesTheRunThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto page = folder.path() / "index.html";
  EXPECT_TRUE(contains(
      error_of([&] { render_runs_page({.folders = {folder.path() / "gone"}, .page = page}); }),
      "gone"));
}

}  // namespace
}  // namespace castaway::testbed
