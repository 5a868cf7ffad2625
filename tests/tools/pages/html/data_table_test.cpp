#include "tools/pages/html/data_table.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(DataTable, HasTheTextAndTheNumberOfEachCell) {
  DataTable table{"errors", {"name", "error [m]", ""}, {}};
  table.rows.push_back({"a < b", number_cell(0.123456, "m"), {"c", std::nullopt, "<b>c</b>"}});
  const std::string html = data_table_html(table, "Nothing.");
  EXPECT_TRUE(contains(html, "data-name=\"errors\""));
  EXPECT_TRUE(contains(html, "<td data-head=\"name\">a &lt; b</td>"));
  EXPECT_TRUE(contains(html, "<td data-head=\"error [m]\" data-value=\"0.123456\">0.123 m</td>"));
  EXPECT_TRUE(contains(html, "<td><b>c</b></td>"));
}

TEST(DataTable, WithoutRowsIsASentence) {
  EXPECT_EQ(data_table_html({"x", {"name"}, {}}, "No <rows>."),
            "<p class=\"soft\">No &lt;rows&gt;.</p>\n");
}

TEST(DataTable, CellsOfNumbers) {
  EXPECT_EQ(count_cell(12345).text, "12345");
  EXPECT_EQ(number_cell(std::nullopt).text, "–");
  EXPECT_EQ(number_cell(0.00005).text, "0.0001");
  EXPECT_EQ(number_cell(-0.0000321, "m").text, "-3e-05 m");  // Not 0.
  EXPECT_FALSE(number_cell(std::nullopt).value);
}

}  // namespace
}  // namespace castaway::testbed
