#include "tools/pages/campaign/specification_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

TEST(SpecificationSection, ListsWhatVariesAndTheRest) {
  CampaignOfRows campaign(
      "name: <mine>\nscenario: {world: lab}\nseeds: 3\ngrid:\n  lidar.range_max: [3, 6]\n"
      "  localizers: [[mh_amcl], [{amcl: {preset: amcl-recovery}}]]\n"
      "draw: {events.0.kidnap.at_s: {uniform: [8, 18]}}\n");
  const std::string html = specification_section(campaign.spec());
  EXPECT_TRUE(
      contains(html, "<span>lidar.range_max [m]</span></td><td data-head=\"values\">3, 6</td>"));
  EXPECT_TRUE(contains(html, ">mh_amcl; amcl (preset amcl-recovery)</td>"));
  EXPECT_TRUE(contains(html, "<span>events.0.kidnap.at_s [s]</span>"));
  EXPECT_TRUE(contains(html, ">uniform 8, 18</td>"));
  EXPECT_TRUE(contains(html, "<td data-head=\"\">seeds</td>"));
  EXPECT_TRUE(contains(html, "<pre>name: &quot;&lt;mine&gt;&quot;"));
  EXPECT_TRUE(contains(html, "world: lab"));
}

}  // namespace
}  // namespace castaway::testbed
