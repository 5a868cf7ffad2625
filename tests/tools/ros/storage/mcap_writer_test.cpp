#include "tools/ros/storage/mcap_writer.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "tests/tools/support/mcap_file.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using namespace std::string_literals;

template <typename T>
T number_at(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// Kinds and offsets of the records from `begin` to the closing magic.
std::vector<std::pair<int, std::size_t>> records_of(const std::string& bytes, std::size_t begin) {
  std::vector<std::pair<int, std::size_t>> records;
  while (begin + 8 < bytes.size()) {
    records.emplace_back(bytes[begin], begin);
    begin += 9 + number_at<std::uint64_t>(bytes, begin + 1);
  }
  return records;
}

std::vector<int> kinds_of(const std::string& bytes, std::size_t begin) {
  std::vector<int> kinds;
  for (const auto& [kind, at] : records_of(bytes, begin)) kinds.push_back(kind);
  return kinds;
}

TEST(McapWriter, WritesAnEmptyFileByTheBook) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "empty.mcap";
  McapOptions options;
  options.library = "x";
  McapWriter(path, options).finish();
  const std::string bytes = read_file(path);
  const std::string front =
      "\x89MCAP0\r\n"
      "\x01\x0D\0\0\0\0\0\0\0\x04\0\0\0ros2\x01\0\0\0x"
      "\x0F\x04\0\0\0\0\0\0\0"s;
  EXPECT_EQ(bytes.substr(0, front.size()), front);
  EXPECT_EQ(bytes.substr(bytes.size() - 8), "\x89MCAP0\r\n"s);
  EXPECT_EQ(kinds_of(bytes, 8), (std::vector<int>{0x01, 0x0F, 0x0B, 0x0E, 0x02}));
}

TEST(McapWriter, PutsAnIndexOfEachChannelBehindEachChunk) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.mcap";
  write_texts(path, {Compression::kNone, 1000, "ros2", "x"}, 10);
  const std::string bytes = read_file(path);
  EXPECT_EQ(kinds_of(bytes, 8),
            (std::vector<int>{0x01, 0x09, 0x06, 0x07, 0x07, 0x06, 0x07, 0x07, 0x0C, 0x0F,  // data
                              0x03, 0x04, 0x04, 0x0B, 0x0D, 0x0A, 0x08, 0x08,  // summary
                              0x0E, 0x0E, 0x0E, 0x0E, 0x0E, 0x0E, 0x02}));
}

TEST(McapWriter, SaysWhereItsSummaryIs) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.mcap";
  write_texts(path, {}, 10);
  const std::string bytes = read_file(path);
  const std::size_t footer = bytes.size() - 8 - 20;
  const auto summary = number_at<std::uint64_t>(bytes, footer);
  const auto offsets = number_at<std::uint64_t>(bytes, footer + 8);
  EXPECT_EQ(bytes[summary], 0x03);
  EXPECT_EQ(bytes[offsets], 0x0E);
  for (const auto& [kind, at] : records_of(bytes, offsets)) {
    if (kind != 0x0E) continue;
    EXPECT_EQ(bytes[number_at<std::uint64_t>(bytes, at + 10)], bytes[at + 9]);
  }
}

TEST(McapWriter, GivesTheSameBytesForTheSameCalls) {
  const TemporaryFolder folder;
  for (const auto compression : {Compression::kNone, Compression::kZstd, Compression::kLz4}) {
    write_texts(folder.path() / "a.mcap", {compression}, 100);
    write_texts(folder.path() / "b.mcap", {compression}, 100);
    EXPECT_EQ(read_file(folder.path() / "a.mcap"), read_file(folder.path() / "b.mcap"));
  }
}

TEST(McapWriter, KeepsChunksWithinTheirSize) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.mcap";
  write_texts(path, {Compression::kNone, 5000, "ros2", "x"}, 1000);
  const std::string bytes = read_file(path);
  int chunks = 0;
  for (const auto& [kind, at] : records_of(bytes, 8)) {
    if (kind != 0x06) continue;
    EXPECT_LE(number_at<std::uint64_t>(bytes, at + 9 + 16), 5200U);  // The first one includes its
                                                                     // schema.
    ++chunks;
  }
  EXPECT_GT(chunks, 20);
}

TEST(McapWriter, RefusesWhatWasNotAdded) {
  const TemporaryFolder folder;
  McapWriter writer(folder.path() / "a.mcap");
  EXPECT_THROW(writer.add_channel({3, "/a", "cdr", {}}), std::invalid_argument);
  EXPECT_THROW(writer.write(0, 0, "x"), std::invalid_argument);
}

TEST(McapWriter, LeavesNothingBehindUnlessItFinishes) {
  const TemporaryFolder folder;
  { const McapWriter writer(folder.path() / "a.mcap"); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace castaway::testbed
