#include "tools/base/formats/csv.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(Csv, HasFixedNumbersAndQuotedTexts) {
  const TemporaryFolder folder;
  CsvWriter csv(folder.path() / "t.csv", {"a", "b", "c", "d", "e"});
  csv.number(1.0 / 3.0).number(-0.0000001).count(-7).text("x, \"y\"").empty().end_row();
  csv.commit();
  EXPECT_EQ(read_file(folder.path() / "t.csv"),
            "a,b,c,d,e\n0.333333,0.000000,-7,\"x, \"\"y\"\"\",\n");
}

TEST(Csv, IsUtf8WhateverTheNamesAre) {
  const TemporaryFolder folder;
  CsvWriter csv(folder.path() / "t.csv", {"caf\xe9"});
  csv.text("a,\xff").end_row();
  csv.commit();
  EXPECT_EQ(read_file(folder.path() / "t.csv"), "caf\xef\xbf\xbd\n\"a,\xef\xbf\xbd\"\n");
}

TEST(Csv, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  CsvWriter csv(folder.path() / "t.csv", {"name", "x", "y", "yaw"});
  csv.text("two\nlines").pose(localization::SE2{1.5, -2.0, 0.25}).end_row();
  csv.text("").pose(std::nullopt).end_row();
  csv.commit();
  const CsvTable table = read_csv(folder.path() / "t.csv");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][table.column("name")], "two\nlines");
  EXPECT_EQ(csv_number(table.rows[0][table.column("y")]), -2.0);
  EXPECT_EQ(csv_number(table.rows[1][table.column("yaw")]), std::nullopt);
}

TEST(Csv, TellsWhatIsWrong) {
  const TemporaryFolder folder;
  const auto path = folder.put("t.csv", "a,b\n1,2\n3\n");
  EXPECT_TRUE(
      contains(error_of([&] { read_csv(path); }), "t.csv:3: 1 cells where the header has 2"));
  EXPECT_TRUE(contains(error_of([] { (void)CsvTable{{"a"}, {}}.column("b"); }), "no column 'b'"));
  EXPECT_TRUE(contains(error_of([] { csv_number("1x"); }), "'1x' is no number"));
}

}  // namespace
}  // namespace castaway::testbed
