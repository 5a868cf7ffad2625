#include "tools/live/server/live_http.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

TEST(LiveFiles, KeepsFilesWithinTheirFolder) {
  const TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path() / "files";
  LiveFiles files(folder);
  EXPECT_FALSE(std::filesystem::exists(folder));
  EXPECT_EQ(files.keep("map.yaml", "a"), "");
  EXPECT_EQ(files.keep("map.yaml", "b"), "");
  EXPECT_EQ(read_file(folder / "map.yaml"), "b");
  EXPECT_EQ(files.keep("robot_description/meshes/base.stl", "c"), "");
  EXPECT_EQ(read_file(folder / "robot_description/meshes/base.stl"), "c");
  EXPECT_NE(files.keep("map.yaml/b", "d"), "");  // There is a file.
  for (const char* name :
       {"", "..", "../x", "a/../b", "a//b", "/a", "a/", "a/.b", ".profile", "-x", "a\\b"}) {
    EXPECT_THAT(files.keep(name, "x"), HasSubstr("name")) << name;
  }
}

TEST(LiveFiles, AreLimitedInNumberAndBytes) {
  const TemporaryFolder temporary;
  LiveFiles few(temporary.path(), {100, 2});
  EXPECT_EQ(few.keep("a", "1"), "");
  EXPECT_EQ(few.keep("b", "1"), "");
  EXPECT_THAT(few.keep("c", "1"), HasSubstr("more than 2 files"));
  LiveFiles small(temporary.path(), {10, 99});
  EXPECT_EQ(small.keep("a", std::string(9, 'x')), "");
  EXPECT_THAT(small.keep("a", std::string(2, 'x')), HasSubstr("MiB"));
}

TEST(ReadReport, OnlyByItsNumber) {
  const TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  std::filesystem::create_directories(folder / "12");
  write_file(folder / "12/report.html", "<p>");
  write_file(folder / "report.html", "secret");
  EXPECT_EQ(read_report("/report/12", folder), "<p>");
  for (const char* path : {"/report/", "/report/.", "/report/../12", "/report/1", "/report/12/",
                           "/report/1234567", "/12", "/report/x"}) {
    EXPECT_FALSE(read_report(path, folder)) << path;
  }
}

}  // namespace
}  // namespace castaway::testbed
