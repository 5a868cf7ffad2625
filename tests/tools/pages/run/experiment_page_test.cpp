#include "tools/pages/run/experiment_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/experiment_outcomes.hpp"
#include "tests/tools/support/page_plots.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

std::string page_of(int number) {
  ExperimentPage page;
  page.experiment = paper_experiment(number, 1, false);
  const std::vector<ExperimentOutcome> outcomes{outcome_with(page.experiment, 1, 1.0),
                                                outcome_with(page.experiment, 2, 3.0)};
  page.rows = two_runs_of_rows();
  page.summary = summarise(page.experiment, outcomes, page.rows);
  page.table = experiment_table(page.experiment, page.summary, timing_of(outcomes));
  page.example = example_run(outcomes);
  page.command = "castaway experiment <n>";
  EXPECT_EQ(page.example, 1U);  // the slower recovery
  return render_experiment(page);
}

TEST(ExperimentPage, ShowsTheTable) {
  const std::string html = page_of(1);
  for (const char* part : {"0.109 +- 0.039", "<code>castaway experiment &lt;n&gt;</code>"}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
  EXPECT_FALSE(contains(html, "ROC curves"));
  EXPECT_FALSE(contains(html, "://"));  // no external resources
  EXPECT_EQ(contains(html, "This page has no plots"), !plots_bundle());
}

TEST(ExperimentPage, DescribesTheCurvesOfTheExample) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  const std::string html = page_of(1);
  EXPECT_TRUE(contains(html, "seed 2."));
  const auto plots = plots_in(html);
  ASSERT_EQ(plots.size(), 4U);
  EXPECT_EQ(plots[0].dump(),
            R"({"title":"Position error","unit":"m","y":{"log":[0.001,100]},)"
            R"("series":[{"name":"a","y":[0.1,4.1]}],"localizers":true,"times":[1,2]})");
  EXPECT_EQ(plots[1].at("series")[0].at("y").dump(), "[0.9,0.3]");
  EXPECT_EQ(plots[2].at("series")[0].at("y").dump(), "[0.01,0.01]");
  EXPECT_EQ(plots[3].at("series")[0].at("y").dump(), "[1,3]");
}

TEST(ExperimentPage, OfRecoveriesShowsWhatTellsRightFromWrong) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  const auto plots = plots_in(page_of(2));
  ASSERT_EQ(plots.size(), 7U);
  EXPECT_EQ(plots[4].at("x").dump(), R"({"label":"position error [m]","log":[0.001,100]})");
  EXPECT_EQ(plots[4].at("series").dump(),
            R"([{"name":"a","style":"dots","x":[0.1,4.1,0.1,4.1],"y":[0.9,0.3,0.9,0.3]}])");
  EXPECT_EQ(plots[6].at("title"), "a");
  EXPECT_EQ(plots[6].at("y").at("label"), "right outputs passed, share");
  // Every right output has a higher quality than every wrong one: the curve goes up first, then
  // right.
  EXPECT_EQ(plots[6].at("series")[0].dump(),
            R"({"name":"quality","x":[0,0,1],"y":[0,1,1],"color":2,"dash":0})");
}

}  // namespace
}  // namespace castaway::testbed
