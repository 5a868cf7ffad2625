#include "tools/report/experiment_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/experiment_outcomes.hpp"
#include "tests/tools/support/temporary.hpp"

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

TEST(ExperimentPage, ShowsTheTableAndTheCurves) {
  const std::string html = page_of(1);
  for (const char* part : {"0.109 +- 0.039", "<code>castaway experiment &lt;n&gt;</code>",
                           "Error over time", "Hypotheses over time", "seed 2"}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
  EXPECT_FALSE(contains(html, "ROC curves"));
  EXPECT_FALSE(contains(html, "http"));  // nothing from elsewhere
}

TEST(ExperimentPage, OfRecoveriesShowsWhoTellsRightFromWrong) {
  const std::string html = page_of(2);
  EXPECT_TRUE(contains(html, "Quality and uncertainty against error"));
  EXPECT_TRUE(contains(html, "right outputs passed, share"));
}

}  // namespace
}  // namespace castaway::testbed
