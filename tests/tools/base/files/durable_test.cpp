#include "tools/base/files/durable.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {
namespace {

TEST(FolderOf, IsTheWorkingFolderIfTheFileNamesNone) {
  EXPECT_EQ(folder_of("a/b.txt"), "a");
  EXPECT_EQ(folder_of("b.txt"), ".");
}

TEST(Durable, AFileTakesThePlaceOfTheOldOne) {
  const TemporaryFolder folder;
  const auto path = folder.put("out/a.txt", "old");
  write_durable(folder.path() / "draft", path, "new");
  EXPECT_EQ(read_file(path), "new");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "draft"));
}

TEST(Durable, AFolderMovesWithAllThatIsInIt) {
  const TemporaryFolder folder;
  folder.put("draft/deep/a.txt", "a");
  move_durable(folder.path() / "draft", folder.path() / "done");
  EXPECT_EQ(read_file(folder.path() / "done/deep/a.txt"), "a");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "draft"));
}

TEST(Durable, WhatCannotBeWrittenIsTroubleWithTheDisk) {
  const TemporaryFolder folder;
  const auto file = folder.put("a", "");
  EXPECT_THROW(write_durable(folder.path() / "draft", file / "b", "x"), FileError);
  EXPECT_THROW(write_durable(file / "draft", folder.path() / "b", "x"), FileError);
  EXPECT_THROW(sync_path(folder.path() / "none"), FileError);
  folder.put("other/x", "");
  folder.put("full/y", "");
  EXPECT_THROW(move_durable(folder.path() / "other", folder.path() / "full"), FileError);
}

}  // namespace
}  // namespace castaway::testbed
