#include "tools/base/bytes/byte_reader.hpp"

#include <gtest/gtest.h>

#include "tools/base/bytes/byte_writer.hpp"

namespace castaway::testbed {
namespace {

TEST(ByteReader, ReadsWhatWasAppended) {
  std::string bytes;
  append_number(bytes, std::uint16_t{0x0201});
  append_text(bytes, "ab");
  append_texts(bytes, {{"k", "v"}, {"l", ""}});
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x01\x02\x02\0\0\0ab", 8));
  ByteReader reader(bytes);
  EXPECT_EQ(reader.number<std::uint16_t>(), 0x0201);
  EXPECT_EQ(reader.text(), "ab");
  EXPECT_EQ(reader.texts(), (std::map<std::string, std::string>{{"k", "v"}, {"l", ""}}));
  EXPECT_EQ(reader.rest(), 0U);
  EXPECT_EQ(reader.position(), bytes.size());
}

TEST(ByteReader, RefusesLengthsBeyondTheEnd) {
  const std::string bytes(
      "\xFF\xFF\xFF\x7F"
      "ab",
      6);
  EXPECT_THROW(ByteReader(bytes).text(), std::runtime_error);
  EXPECT_THROW(ByteReader(bytes).texts(), std::runtime_error);
  EXPECT_THROW(ByteReader(bytes).number<std::uint64_t>(), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
