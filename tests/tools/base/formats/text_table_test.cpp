#include "tools/base/formats/text_table.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

const TextTable kFigures{{"", "recovered", "time"},
                         {{"mh_amcl", "3 of 3", "0.15 s"}, {"a", "0 of 3", "-"}}};

TEST(TextTable, PadsColumnsToTheirWidestCell) {
  EXPECT_EQ(as_text(kFigures),
            "            recovered     time\n"
            "  mh_amcl      3 of 3   0.15 s\n"
            "  a            0 of 3        -\n");
}

TEST(TextTable, IsTurnedWhereItIsWiderThanTheTerminal) {
  EXPECT_EQ(as_text(kFigures, 30), as_text(kFigures));
  EXPECT_EQ(as_text(kFigures, 29),
            "  mh_amcl\n"
            "    recovered  3 of 3\n"
            "    time       0.15 s\n"
            "  a\n"
            "    recovered  0 of 3\n"
            "    time       -\n");
}

TEST(TextTable, CountsWhatATerminalShows) {
  EXPECT_EQ(shown_length("\033[1;32m3 of 3\033[0m"), 6U);
  EXPECT_EQ(shown_length("Größe"), 5U);
  const TextTable coloured{{"", "x"}, {{"a", "\033[31m1\033[0m"}, {"b", "12"}}};
  EXPECT_EQ(as_text(coloured), "       x\n  a    \033[31m1\033[0m\n  b   12\n");
}

TEST(TextTable, IsATableOfMarkdown) {
  const TextTable table{{"", "found"}, {{"a|b", "3 of 3"}, {"two\nlines", "back\\slash"}}};
  EXPECT_EQ(as_markdown(table),
            "|  | found |\n|---|---:|\n| a\\|b | 3 of 3 |\n| two lines | back\\\\slash |\n");
}

}  // namespace
}  // namespace castaway::testbed
