#include "tools/pages/run/comparison_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

Comparison made_up() {
  Comparison comparison{"before", "after", 20, 1, 0, {}};
  comparison.metrics = {{"a.error", 20, 0.2, 0.1, -0.1, Interval{-0.12, -0.08}, false, false, 0.01},
                        {"a.success", 20, 0.9, 0.8, -0.1, Interval{-0.2, -0.01}, true, false, 0.04},
                        {"a.<odd>", 1, 2.0, 3.0, 1.0, std::nullopt, false, false, 1.0, 8},
                        {"collisions", 20, 0.0, 0.0, 0.0, Interval{0.0, 0.0}, false, false, 1.0},
                        {"timing", 20, 1.0, 2.0, 1.0, Interval{0.9, 1.1}, false, true}};
  return comparison;
}

TEST(ComparisonTable, SaysWhatIsBetterAndWorse) {
  const TextTable table = comparison_table(made_up());
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"a.error", "20", "0.2", "0.1", "-0.1",
                                                     "[-0.12, -0.08]", "0.010", "better"}));
  EXPECT_EQ(table.rows[1].back(), "worse");
  EXPECT_EQ(table.rows[2].back(), "too few pairs: takes 8");
  EXPECT_EQ(table.rows[3].back(), "no difference seen");
  EXPECT_EQ(table.rows[4].back(), "clock, not judged");
}

TEST(ComparisonPage, ShowsTableAndDifferences) {
  const std::string html = render_comparison({made_up()});
  EXPECT_TRUE(contains(html, "after against before"));
  EXPECT_TRUE(contains(html, "20 pairs"));
  EXPECT_TRUE(contains(html, "a.&lt;odd&gt;"));
  EXPECT_TRUE(contains(html, "-50 %"));
  EXPECT_FALSE(contains(html, "nan"));  // a baseline of zero has no percentage
}

// With the dashes of a localizer's colour, intervals and their centres would lose their dots.
TEST(ComparisonPage, DrawsIntervalsWithoutDashes) {
  const std::string html = render_comparison({made_up()});
  EXPECT_TRUE(contains(html, "<line class=\"bar better\""));
  EXPECT_TRUE(contains(html, "<circle class=\"bar worse\""));
  EXPECT_TRUE(contains(html, ".bar { stroke-dasharray: none; }"));
  EXPECT_FALSE(contains(html, "<circle class=\"limit\""));
}

// Green and red stand for verdicts, not for localizers; these have a square before their figures.
TEST(ComparisonPage, MarksTheFiguresOfALocalizerInItsColour) {
  Comparison comparison = made_up();
  for (const char* name :
       {"amcl.availability", "amcl.recovery.success", "amclx.recovery.success"}) {
    comparison.metrics.push_back(comparison.metrics.front());
    comparison.metrics.back().metric = name;
  }
  const std::string html = render_comparison({comparison});
  // Two of the three have it: a square, then the name.
  const std::string square = "<rect style=\"fill:var(--c1)\"";
  std::size_t squares = 0;
  for (std::size_t at = html.find(square); at != std::string::npos;
       at = html.find(square, at + 1)) {
    ++squares;
    EXPECT_TRUE(contains(html.substr(at, 200), ">amcl."));
  }
  EXPECT_EQ(squares, 2U);
}

// On a phone, each row is a block in which every cell follows its column's name.
TEST(ComparisonPage, NamesTheColumnOfEachCell) {
  const std::string html = render_comparison({made_up()});
  EXPECT_TRUE(contains(html, "<td>a.error</td><td data-head=\"pairs\">20</td>"));
  EXPECT_TRUE(contains(html, "<td>better</td></tr>"));
}

}  // namespace
}  // namespace castaway::testbed
