#include "tools/base/bytes/utf8.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

TEST(Utf8, HoldsCharactersOfOneToFourBytes) {
  for (const char* text : {"", "abc", "caf\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\xa4\x96",
                           "\xed\x9f\xbf", "\xee\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_FALSE(find_invalid_utf8(text)) << text;
    EXPECT_EQ(valid_utf8(text), text);
  }
}

TEST(Utf8, HoldsNoOtherBytes) {
  EXPECT_EQ(find_invalid_utf8("caf\xe9"), 3U);           // Latin-1
  EXPECT_EQ(find_invalid_utf8("\xc0\xaf"), 0U);          // A slash in two bytes.
  EXPECT_EQ(find_invalid_utf8("a\xed\xa0\x80"), 1U);     // A surrogate.
  EXPECT_EQ(find_invalid_utf8("\xf4\x90\x80\x80"), 0U);  // Above U+10FFFF.
  EXPECT_EQ(find_invalid_utf8("\xf0\x8f\xbf\xbf"), 0U);  // Three bytes would do.
  EXPECT_EQ(find_invalid_utf8("\xe2\x82"), 0U);          // Cut off.
  EXPECT_EQ(find_invalid_utf8("\x80"), 0U);
  EXPECT_EQ(find_invalid_utf8("\xff"), 0U);
}

TEST(Utf8, IsReplacedByteByByte) {
  EXPECT_EQ(valid_utf8("caf\xe9 \xc3\xa9 \xe2\x82"),
            "caf\xef\xbf\xbd \xc3\xa9 \xef\xbf\xbd\xef\xbf\xbd");
}

TEST(PrintableLines, KeepLayoutAndColoursAndNoOtherControlCharacters) {
  EXPECT_EQ(printable_lines("  a \tb  \n\nc\n"), "  a \tb  \n\nc\n");
  EXPECT_EQ(printable_lines("\x1b[1;32m3 of 3\x1b[0m  \n"), "\x1b[1;32m3 of 3\x1b[0m  \n");
  EXPECT_EQ(printable_lines("\x1b[31mx\x07\ry"), "\xef\xbf\xbd[31mx\xef\xbf\xbd y");
  EXPECT_EQ(printable_lines("\xc2\x9b"
                            "31m\xc3\xbc"),
            "\xef\xbf\xbd"
            "31m\xc3\xbc");
  EXPECT_EQ(printable_lines(""), "");
}

TEST(Printable, IsOneLineWithoutControlCharacters) {
  EXPECT_EQ(printable("a\r\n\tb\n"), "a   b");
  const std::string replacement = "\xef\xbf\xbd";
  EXPECT_EQ(printable("\x1b]0;title\x07"), replacement + "]0;title" + replacement);
  EXPECT_EQ(printable(std::string("a\0\x7f", 3)), "a" + replacement + replacement);
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m \xc2\xa0"),
            replacement + "31m \xc2\xa0");  // CSI in UTF-8.
  EXPECT_EQ(printable("\x9b"
                      "31m caf\xe9"),
            replacement + "31m caf" + replacement);
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac"), "caf\xc3\xa9 \xe2\x82\xac");
}

TEST(JsonText, IsWrittenWhateverTheNamesAre) {
  const nlohmann::ordered_json json{{"caf\xe9", "\xff"}};
  EXPECT_EQ(json_text(json), "{\"caf\xef\xbf\xbd\":\"\xef\xbf\xbd\"}");
  EXPECT_EQ(json_text(json, 1), "{\n \"caf\xef\xbf\xbd\": \"\xef\xbf\xbd\"\n}");
}

}  // namespace
}  // namespace castaway::testbed
