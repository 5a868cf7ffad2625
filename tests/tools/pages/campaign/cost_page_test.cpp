#include "tools/pages/campaign/cost_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"

namespace castaway::testbed {
namespace {

TEST(CostPage, HasTotalsMeansAndTheMostExpensiveCells) {
  const auto campaign = campaign_of_kidnaps();
  const auto axes = key_axes(campaign->spec(), campaign->rows());
  const std::string html = render_cost_page(campaign->finished(), axes);
  EXPECT_TRUE(contains(html, "data-value=\"21\">21.0<"));      // CPU time: 1 + 2 + ... + 6 s.
  EXPECT_TRUE(contains(html, "data-value=\"120\">120<"));      // Simulated: 6 runs of 20 s.
  EXPECT_TRUE(contains(html, "data-value=\"0.175\">0.175<"));  // CPU time of a simulated second.
  EXPECT_TRUE(contains(html, "data-value=\"5\">5.00<"));       // Mean with two people.
  const std::size_t expensive = html.find("data-name=\"expensive\"");
  const std::size_t first = html.find("<td", expensive);
  EXPECT_EQ(html.substr(first, 38), "<td data-head=\"cell\" data-value=\"5\">5<");
}

TEST(CostPage, OfFailuresHasNoSimulatedTime) {
  const auto campaign = campaign_of_failures();
  const std::string html = render_cost_page(campaign->finished(), {});
  EXPECT_FALSE(contains(html, "of a simulated second"));
  EXPECT_FALSE(contains(html, "nan"));
}

}  // namespace
}  // namespace castaway::testbed
