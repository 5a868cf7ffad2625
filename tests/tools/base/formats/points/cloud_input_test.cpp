#include "tools/base/formats/points/cloud_input.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(CloudWords, AreSeparatedByBlanks) {
  CloudWords words(" a\tbc \r");
  EXPECT_EQ(words.next(), "a");
  EXPECT_EQ(words.next(), "bc");
  EXPECT_EQ(words.next(), "");
  EXPECT_EQ(words.next(), "");
}

TEST(CloudInput, TakesLinesThenBytes) {
  CloudInput input("one\n \r\n\ntwo\r\n\n23", "a");
  EXPECT_EQ(input.line(), "one");
  EXPECT_EQ(input.line(), "two\r");
  EXPECT_TRUE(contains(error_of([&] { input.fail_in_line("bad"); }), "a:4: bad"));
  EXPECT_EQ(input.take(1, 1), "\n");
  EXPECT_TRUE(contains(error_of([&] { (void)input.take(1, 3); }), "a: cut short: 1 x 3 bytes"));
  EXPECT_TRUE(contains(error_of([&] { input.require(UINT64_MAX, 8); }), "cut short"));
  EXPECT_EQ(input.take(2, 1), "23");
  EXPECT_TRUE(contains(error_of([&] { (void)input.line(); }), "a: cut short after line 4"));
}

TEST(CloudInput, NeedsEachAxisOnce) {
  const CloudInput input("", "a");
  input.require_xyz({axis_of("z"), axis_of("intensity"), axis_of("y"), axis_of("x")});
  EXPECT_TRUE(contains(error_of([&] {
                         input.require_xyz({0, 1, 2, 1});
                       }),
                       "2 fields are named 'y'"));
  EXPECT_TRUE(contains(error_of([&] { input.require_xyz({-1, 1, 2}); }), "0 fields are named 'x'"));
}

TEST(QuoteWord, ShortensAndCleans) {
  EXPECT_EQ(quote_word("a\x01 \xff"), "'a? ?'");
  EXPECT_EQ(quote_word(std::string(99, 'b')), "'" + std::string(40, 'b') + "'");
}

}  // namespace
}  // namespace castaway::testbed
