#include "tools/report/runs_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/files/file.hpp"
#include "tools/sinks/errors_sink.hpp"
#include "tools/sinks/summary_sink.hpp"

namespace castaway::testbed {
namespace {

/// Writes a run of three scans with these localizers and returns its folder.
std::filesystem::path run_in(const std::filesystem::path& folder,
                             const std::vector<std::string>& localizers) {
  ErrorsSink errors(folder);
  SummarySink summary(folder, run_of(localizers));
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
  write_runs_page({one, two}, folder.path() / "pages/index.html");
  const std::string html = read_file(folder.path() / "pages/index.html");
  EXPECT_TRUE(contains(html, "<h1>2 runs</h1>"));
  EXPECT_TRUE(contains(html,
                       "<td rowspan=\"2\"><a href=\"../runs/a%20%231/report.html\">"
                       "a-scenario, seed 7</a></td>"));
  EXPECT_TRUE(contains(html, "<a href=\"../runs/two/report.html\">"));
  EXPECT_TRUE(contains(html, "<strong>&lt;b&gt;</strong> was never displaced."));
  EXPECT_TRUE(contains(html, "<td>0.200 m</td>"));
  EXPECT_EQ(html.find("<b>"), std::string::npos);
}

TEST(RunsPage, ShowsARunWithoutLocalizers) {
  const TemporaryFolder folder;
  write_runs_page({run_in(folder.path() / "none", {})}, folder.path() / "index.html");
  EXPECT_TRUE(contains(read_file(folder.path() / "index.html"), "no localizer"));
}

TEST(RunsPage, NamesTheRunThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto page = folder.path() / "index.html";
  EXPECT_TRUE(contains(error_of([&] { write_runs_page({folder.path() / "gone"}, page); }), "gone"));
  EXPECT_FALSE(std::filesystem::exists(page));
}

}  // namespace
}  // namespace castaway::testbed
