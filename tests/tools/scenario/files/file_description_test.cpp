#include "tools/scenario/files/file_description.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

std::string described(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder.path() / "file", text);
  return first_sentence(folder.path() / "file");
}

TEST(FileDescription, IsTheFirstSentenceOfTheFirstComment) {
  EXPECT_EQ(described("# A hall of 10.5 m, with\n# two doors. Metres.\nname: hall\n"),
            "A hall of 10.5 m, with two doors");
  EXPECT_EQ(described("# A flat.\n"), "A flat");
  EXPECT_EQ(described("<?xml version=\"1.0\"?>\n<!-- A disc. More. -->\n<robot/>"), "A disc");
  EXPECT_EQ(described("<!-- A disc -->"), "A disc");
}

TEST(FileDescription, IsEmptyWithoutAComment) {
  EXPECT_EQ(described(""), "");
  EXPECT_EQ(described("name: hall\n# Not at the top.\n"), "");
  EXPECT_EQ(described("<robot><!-- wheels --></robot>"), "");
  EXPECT_EQ(described("<!--"), "");
  EXPECT_EQ(described("#"), "");
  EXPECT_EQ(described("<?xml"), "");
}

TEST(FileDescription, IsCutBetweenWords) {
  EXPECT_EQ(shorten("one two three", 13), "one two three");
  EXPECT_EQ(shorten("one two, three", 13), "one two ...");
  EXPECT_EQ(shorten("onetwothree", 8), "onet ...");
}

}  // namespace
}  // namespace castaway::testbed
