#include "tools/formats/file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

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

TEST(File, IsNoDevice) { EXPECT_THROW(read_file("/dev/zero"), std::runtime_error); }

TEST(File, NamesWhatCannotBeReadOrWritten) {
  EXPECT_TRUE(
      contains(error_of([] { read_file("/no/such/file"); }), "/no/such/file: cannot be read"));
  EXPECT_TRUE(contains(error_of([] { read_file("/tmp"); }), "/tmp: cannot be read"));
  EXPECT_TRUE(contains(error_of([] { write_file("/proc/nowhere/file", ""); }),
                       "/proc/nowhere/file: cannot be written"));
}

}  // namespace
}  // namespace castaway::testbed
