#include "tools/base/output/listed_path.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

TEST(ListedPath, LeadsBelowItsFolder) {
  for (const char* path : {"a", "bag/a.mcap", "..a", "a..", ".hidden", "a b/c", "a\\b"}) {
    EXPECT_EQ(listed_path_error(path), "") << path;
  }
}

TEST(ListedPath, IsRelativeAndNormal) {
  const std::string zero("a\0b", 3);
  for (const std::string& path :
       {std::string(), std::string("/"), std::string("/etc/passwd"), std::string(".."),
        std::string("../a"), std::string("a/.."), std::string("a/../../b"), std::string("./a"),
        std::string("a/./b"), std::string("a//b"), std::string("a/"), zero}) {
    EXPECT_NE(listed_path_error(path), "") << path;
  }
  EXPECT_EQ(error_of([] { require_listed_path("runs/.list", "../a"); }),
            "runs/.list: lists the path '../a', which leads out of its folder or back into it; "
            "castaway writes no such list, choose another folder");
}

TEST(RequireNoLink, FindsALinkOnTheWayAndAtTheEnd) {
  const TemporaryFolder folder;
  folder.put("real/a", "a");
  fs::create_directory_symlink("real", folder.path() / "link");
  fs::create_symlink("nowhere", folder.path() / "real/dangling");
  EXPECT_NO_THROW(require_no_link(folder.path(), "real/a"));
  EXPECT_NO_THROW(require_no_link(folder.path() / "link", "a"));
  EXPECT_NO_THROW(require_no_link(folder.path(), "not/there"));
  for (const char* path : {"link", "link/a", "real/dangling"}) {
    EXPECT_TRUE(contains(error_of([&] { require_no_link(folder.path(), path); }), "is a link"));
  }
}

TEST(IsFolderBelow, HoldsForFoldersThatAreReachedThroughNoLink) {
  const TemporaryFolder folder;
  folder.put("real/deep/a", "a");
  fs::create_directory_symlink("real", folder.path() / "link");
  EXPECT_TRUE(is_folder_below(folder.path(), "real/deep"));
  for (const char* path : {"link", "link/deep", "real/deep/a", "none"}) {
    EXPECT_FALSE(is_folder_below(folder.path(), path)) << path;
  }
}

}  // namespace
}  // namespace castaway::testbed
