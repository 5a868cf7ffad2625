#include "tools/base/files/file.hpp"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/sha256.hpp"
#include "tools/base/formats/carmen_log.hpp"
#include "tools/ros/storage/mcap_reader.hpp"

namespace castaway::testbed {
namespace {

TEST(File, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "deep/er/file";
  write_file(path, std::string_view("a\0\r\n", 4));
  EXPECT_EQ(read_file(path), std::string("a\0\r\n", 4));
}

TEST(File, IsNotReadIfItIsTooLong) {
  const TemporaryFolder folder;
  const auto path = folder.put("file", "12345678");
  EXPECT_EQ(read_file(path, 8), "12345678");
  EXPECT_TRUE(contains(error_of([&] { read_file(path, 7); }), "is longer than 0 MiB"));
  std::filesystem::resize_file(path, std::uintmax_t{3} << 30U);  // Takes no room.
  EXPECT_TRUE(contains(error_of([&] { read_file(path); }), "is longer than 1024 MiB"));
  EXPECT_FALSE(read_file("/proc/self/stat").empty());  // States no size.
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

TEST(File, IsWrittenThroughNoLink) {
  const TemporaryFolder folder;
  folder.put("mine", "mine");
  const auto path = folder.path() / "file";
  std::filesystem::create_symlink("mine", path);
  std::filesystem::create_symlink("mine", path.string() + ".part-" + std::to_string(::getpid()));
  write_file(path, "new");
  EXPECT_EQ(read_file(folder.path() / "mine"), "mine");
  EXPECT_EQ(read_file(path), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(path));
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
