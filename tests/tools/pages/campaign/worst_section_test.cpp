#include "tools/pages/campaign/worst_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"

namespace castaway::testbed {
namespace {

TEST(WorstSection, SaysHowToPlayACellAgain) {
  const auto campaign = campaign_of_kidnaps();
  campaign->overrides = {"lidar.beams=90", "start={random: true}"};
  EXPECT_EQ(replay_command(campaign->finished(), 4),
            "castaway campaign s.yaml --set lidar.beams=90 --set 'start={random: true}' --only 4 "
            "--out again");
}

TEST(WorstSection, BeginsWithTheLongestLost) {
  const auto campaign = campaign_of_kidnaps();
  const std::string html =
      worst_section(campaign->finished(), gather_figures(campaign->finished()));
  EXPECT_EQ(times_in(html, "<td data-head=\"cell\""), 12);
  const std::size_t first = html.find("<td data-head=\"cell\"");
  EXPECT_EQ(html.substr(first, 38), "<td data-head=\"cell\" data-value=\"1\">1<");
  EXPECT_TRUE(contains(html, "<code>castaway campaign s.yaml --only 1 --out again</code>"));
  EXPECT_FALSE(contains(html, "href"));
}

TEST(WorstSection, LinksWhatIsKept) {
  const auto campaign = campaign_of_kidnaps();
  const std::filesystem::path cells = campaign->folder() / "cells";
  std::filesystem::create_directories(cells / "000001-0123456789abcdef");
  std::ofstream(cells / "000001-0123456789abcdef/report.html") << "report";
  std::filesystem::create_directories(cells / "000003-0123456789abcdef");
  const std::string html =
      worst_section(campaign->finished(), gather_figures(campaign->finished()));
  EXPECT_TRUE(contains(
      html, "<a href=\"cells/000001-0123456789abcdef/report.html#t=5.0\">report at 5.0 s</a>"));
  EXPECT_TRUE(contains(html, "<a href=\"cells/000003-0123456789abcdef/\">kept</a>"));
}

}  // namespace
}  // namespace castaway::testbed
