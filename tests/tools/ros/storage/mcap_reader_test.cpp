#include "tools/ros/storage/mcap_reader.hpp"

#include <sstream>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/tools/support/mcap_file.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/compression.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using namespace std::string_literals;

McapReader reader_of(const std::string& bytes) {
  return {std::make_unique<std::istringstream>(bytes), "a.mcap"};
}

std::string file_of(const McapOptions& options, int count) {
  const TemporaryFolder folder;
  write_texts(folder.path() / "a.mcap", options, count);
  return read_file(folder.path() / "a.mcap");
}

std::string read_all(const std::string& bytes) {
  McapReader reader = reader_of(bytes);
  texts_of(reader);
  return reader.warning().value_or("");
}

class McapReaderOf : public testing::TestWithParam<Compression> {};

TEST_P(McapReaderOf, ReadsWhatWasWritten) {
  McapReader reader = reader_of(file_of({GetParam(), 2000, "ros2", "x"}, 50));
  const std::vector<std::string> texts = texts_of(reader);
  ASSERT_EQ(texts.size(), 100U);
  EXPECT_EQ(texts[0], "/a 1000000000 a0");
  EXPECT_EQ(texts[99], "/b 1049000000 b49");
  EXPECT_FALSE(reader.warning());
  ASSERT_EQ(reader.channels().size(), 2U);
  const McapChannel& channel = reader.channels().begin()->second;
  EXPECT_EQ(channel.metadata.at("key"), "value");
  EXPECT_EQ(reader.schema_of(channel)->name, "std_msgs/msg/String");
  EXPECT_EQ(reader.schema_of(channel)->data, "string data\n");
  ASSERT_EQ(reader.attachments().size(), 1U);
  EXPECT_EQ(reader.attachments()[0].name, "note.txt");
  EXPECT_EQ(reader.attachments()[0].size, 6U);
  EXPECT_EQ(reader.metadata().at("run").at("seed"), "7");
}

TEST_P(McapReaderOf, ReadsEveryCutAsFarAsItGoes) {
  const std::string bytes = file_of({GetParam(), 700, "ros2", "x"}, 20);
  const std::vector<std::string> all = [&] {
    McapReader reader = reader_of(bytes);
    return texts_of(reader);
  }();
  std::size_t most = 0;
  for (std::size_t size = 8; size < bytes.size(); ++size) {
    McapReader reader = reader_of(bytes.substr(0, size));
    const std::vector<std::string> texts = texts_of(reader);
    ASSERT_TRUE(reader.warning()) << size;
    ASSERT_LE(texts.size(), all.size());
    EXPECT_TRUE(std::equal(texts.begin(), texts.end(), all.begin())) << size;
    EXPECT_GE(texts.size(), most) << size;
    most = std::max(most, texts.size());
  }
  EXPECT_EQ(most, all.size());
}

/// An inverted byte is an error or changes what is read, but never crashes.
TEST_P(McapReaderOf, SurvivesEveryByteTurnedOver) {
  const std::string bytes = file_of({GetParam(), 700, "ros2", "x"}, 6);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const char flip : {'\x01', '\x80', '\xFF'}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      try {
        read_all(damaged);
      } catch (const std::runtime_error& error) {
        EXPECT_TRUE(contains(error.what(), "a.mcap: ")) << at;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, McapReaderOf,
                         testing::Values(Compression::kNone, Compression::kZstd, Compression::kLz4),
                         [](const auto& parameter) {
                           const std::string name = compression_name(parameter.param);
                           return name.empty() ? "none" : name;
                         });

TEST(McapReader, ReadsMessagesOutsideOfChunks) {
  std::string bytes(kMcapMagic);
  const auto record = [&](McapOpcode opcode, const std::string& content) {
    const std::size_t begin = begin_record(bytes, opcode);
    bytes += content;
    end_record(bytes, begin);
  };
  record(McapOpcode::kHeader, "\0\0\0\0\0\0\0\0"s);
  record(McapOpcode::kChannel, "\x05\0\0\0\x02\0\0\0/t\x04\0\0\0json\0\0\0\0"s);
  record(McapOpcode::kMessage, "\x05\0\0\0\0\0\x09\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0{}"s);
  record(McapOpcode::kDataEnd, "\0\0\0\0"s);
  record(McapOpcode::kFooter, std::string(20, '\0'));
  McapReader reader = reader_of(bytes + std::string(kMcapMagic));
  EXPECT_EQ(texts_of(reader), (std::vector<std::string>{"/t 9 {}"}));
  EXPECT_FALSE(reader.warning());
  EXPECT_EQ(reader.schema_of(reader.channels().at(5)), nullptr);
}

TEST(McapReader, NamesFileAndByteOfADamagedChunk) {
  std::string bytes = file_of({Compression::kNone, 2000, "ros2", "x"}, 10);
  const std::size_t at = bytes.find("a3xxx");
  bytes[at + 3] = 'y';
  const std::string error = error_of([&] { read_all(bytes); });
  EXPECT_TRUE(contains(error, "a.mcap: byte "));
  EXPECT_TRUE(contains(error, "a chunk is damaged: its checksum does not fit"));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(McapReader, BelievesNoSize) {
  std::string bytes = file_of({Compression::kZstd, 1 << 20, "ros2", "x"}, 10);
  std::string huge;
  append_number(huge, std::uint64_t{1} << 62);
  std::string claims_much = bytes;
  claims_much.replace(bytes.find("zstd") - 4 - 4 - 8, 8, huge);  // Its uncompressed size.
  EXPECT_TRUE(
      contains(error_of([&] { read_all(claims_much); }), "a chunk claims 4611686018427387904"));
  std::string long_record = bytes;
  long_record.replace(8 + 1, 8, huge);  // The header's length.
  EXPECT_TRUE(contains(error_of([&] { read_all(long_record); }), "more than the file has left"));
}

TEST(McapReader, ReadsNoRecordOfGigabytesThatIsThere) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "sparse.mcap";
  write_texts(path, {}, 3);
  const auto size = std::filesystem::file_size(path);
  const std::uint64_t huge = std::uint64_t{6} << 30U;
  for (const char kind : {'\x04', '\x05', '\x90'}) {  // A channel, a message, a private record.
    std::filesystem::resize_file(path, size + huge);  // A sparse file takes no space.
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(kMcapMagic.size()));
    file.put(kind);
    file.write(reinterpret_cast<const char*>(&huge), sizeof huge);
    file.seekp(static_cast<std::streamoff>(size + huge - kMcapMagic.size()));
    file << kMcapMagic;
    file.close();
    const std::string what = error_of([&] {
      McapReader reader(path);
      while (reader.next()) {
      }
    });
    EXPECT_TRUE(contains(what, kind == '\x90' ? "its kind is 0" : "a record of 6144 MiB")) << what;
  }
}

TEST(McapReader, SaysThatAFileIsOfAnotherKind) {
  EXPECT_TRUE(
      contains(error_of([] { reader_of("SQLite format 3"); }), "a.mcap: is not an MCAP file"));
  EXPECT_TRUE(contains(error_of([] { reader_of(""); }), "a.mcap: is not an MCAP file"));
  EXPECT_TRUE(contains(error_of([] { McapReader reader("no/such.mcap"); }), "cannot be read"));
}

TEST(McapReader, NamesACompressionThatItDoesNotKnow) {
  std::string bytes = file_of({Compression::kZstd, 1 << 20, "ros2", "x"}, 3);
  bytes.replace(bytes.find("zstd"), 4, "snap");
  EXPECT_TRUE(contains(error_of([&] { read_all(bytes); }), "compression 'snap' is not known"));
}

}  // namespace
}  // namespace castaway::testbed
