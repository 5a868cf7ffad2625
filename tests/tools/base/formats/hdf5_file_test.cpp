#include "tools/base/formats/hdf5_file.hpp"

#include <array>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/tools/support/h5dump.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {
namespace {

void write_example(const std::filesystem::path& path) {
  Hdf5File file(path);
  const int ranges = file.add({"/scans/ranges", Hdf5Type::kFloat32, 2, "m", "by beam"});
  const int ids = file.add({"/ids", Hdf5Type::kInt32, 0});
  file.append(ranges, std::vector<double>{1.5, 2.5});
  file.append(ids, std::vector<std::int32_t>{7, -1});
  file.append(ranges, std::vector<float>{3.5F, 4.5F, 5.5F, 6.5F});
  file.write_texts("/scans/names", {"a", "longer"});
  file.set_attribute("/scans", "rate_hz", 10.0);
  file.set_attribute("/", "version", "1");
  file.close();
}

TEST(Hdf5File, AnotherReaderFindsWhatWasWritten) {
  if (!h5dump_works()) GTEST_SKIP() << "h5dump is not installed (hdf5-tools)";
  const TemporaryFolder folder;
  write_example(folder.path() / "a.h5");
  const std::string ranges = h5dump(folder.path() / "a.h5", "-d /scans/ranges");
  EXPECT_TRUE(contains(ranges, "H5T_IEEE_F32LE"));
  EXPECT_TRUE(contains(ranges, "( 3, 2 ) / ( H5S_UNLIMITED, 2 )"));
  EXPECT_TRUE(contains(ranges, "(0,0): 1.5, 2.5"));
  EXPECT_TRUE(contains(ranges, "(2,0): 5.5, 6.5"));
  EXPECT_TRUE(contains(ranges, "ATTRIBUTE \"unit\""));
  EXPECT_TRUE(contains(h5dump(folder.path() / "a.h5", "-d /ids"), "(0): 7, -1"));
  EXPECT_TRUE(contains(h5dump(folder.path() / "a.h5", "-d /scans/names"), "\"longer\""));
  EXPECT_TRUE(contains(h5dump(folder.path() / "a.h5", "-a /scans/rate_hz"), "(0): 10"));
}

TEST(Hdf5File, EqualTablesMakeEqualBytes) {
  const TemporaryFolder folder;
  write_example(folder.path() / "a.h5");
  write_example(folder.path() / "b.h5");
  EXPECT_EQ(read_file(folder.path() / "a.h5"), read_file(folder.path() / "b.h5"));
}

TEST(Hdf5File, WhatCannotBeWrittenIsTroubleWithTheDisk) {
  const TemporaryFolder folder;
  EXPECT_THROW(Hdf5File(folder.path() / "none/a.h5"), FileError);
  folder.put("mine", "mine");
  std::filesystem::create_symlink("mine", folder.path() / "link.h5");
  EXPECT_THROW(Hdf5File(folder.path() / "link.h5"), FileError);
  EXPECT_THROW(Hdf5File(folder.path() / "mine"), FileError);
  EXPECT_EQ(read_file(folder.path() / "mine"), "mine");
}

}  // namespace
}  // namespace castaway::testbed
