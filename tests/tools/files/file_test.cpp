#include "tools/files/file.hpp"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/files/sha256.hpp"
#include "tools/formats/carmen_log.hpp"
#include "tools/ros/mcap/mcap_reader.hpp"

namespace castaway::testbed {
namespace {

TEST(File, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "deep/er/file";
  write_file(path, std::string_view("a\0\r\n", 4));
  EXPECT_EQ(read_file(path), std::string("a\0\r\n", 4));
}

TEST(File, IsNotThereBeforeItIsComplete) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  {
    AtomicFile file(path);
    file.write("half");
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(File, KeepsTheOldOneUntilTheNewOneIsComplete) {
  const TemporaryFolder folder;
  const auto path = folder.put("file", "old");
  AtomicFile file(path);
  file.write("new");
  EXPECT_EQ(read_file(path), "old");
  file.commit();
  EXPECT_EQ(read_file(path), "new");
}

TEST(File, IsNoDevicePipeOrFolder) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero"), folder.path().string()}) {
    const std::string expected = path + ": cannot be read: it is a";
    EXPECT_TRUE(contains(error_of([&] { read_file(path); }), expected)) << path;
    EXPECT_TRUE(contains(error_of([&] { sha256_of_file(path); }), expected)) << path;
    EXPECT_TRUE(contains(error_of([&] { CarmenLogReader reader(path); }), expected)) << path;
    EXPECT_TRUE(contains(error_of([&] { McapReader reader(path); }), expected)) << path;
  }
}

TEST(File, IsNotReadWhereItIsOnlyAPointerOfGitLfs) {
  const TemporaryFolder folder;
  write_file(folder.path() / "map.png",
             "version https://git-lfs.github.com/spec/v1\noid sha256:a\nsize 9\n");
  EXPECT_THROW((void)read_file(folder.path() / "map.png"), std::runtime_error);
}

TEST(File, NamesWhatCannotBeReadOrWritten) {
  EXPECT_TRUE(
      contains(error_of([] { read_file("/no/such/file"); }), "/no/such/file: cannot be read"));
  EXPECT_TRUE(contains(error_of([] { read_file("/tmp"); }), "/tmp: cannot be read"));
  EXPECT_TRUE(contains(error_of([] { write_file("/proc/nowhere/file", ""); }),
                       "/proc/nowhere/file: cannot be written"));
}

}  // namespace
}  // namespace castaway::testbed
