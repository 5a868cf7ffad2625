#include "tools/ros/storage/mcap_reader.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/byte_writer.hpp"

namespace castaway::testbed {
namespace {

/// Content of an uncompressed chunk of "hello" that claims these values.
std::string chunk(std::uint64_t size, std::uint32_t crc, std::uint64_t packed_size) {
  std::string bytes(16, '\0');
  append_number(bytes, size);
  append_number(bytes, crc);
  append_text(bytes, "");
  append_number(bytes, packed_size);
  return bytes + "hello";
}

constexpr std::uint32_t kCrcOfHello = 0x3610A686;

TEST(McapChunk, IsOpenedWithItsChecksumOrWithoutOne) {
  EXPECT_EQ(open_chunk(chunk(5, kCrcOfHello, 5), true), "hello");
  EXPECT_EQ(open_chunk(chunk(5, 0, 5), true), "hello");
}

TEST(McapChunk, IsRefusedWhereItsClaimsDoNotFit) {
  const auto refusal = [](const std::string& content) {
    return error_of([&] { open_chunk(content, true); });
  };
  EXPECT_TRUE(contains(refusal(chunk(5, 1, 5)), "checksum does not fit"));
  EXPECT_TRUE(contains(refusal(chunk(6, 0, 5)), "claims 6 bytes and holds 5"));
  EXPECT_TRUE(contains(refusal(chunk(4, 0, 5)), "more than the 4 bytes"));
  EXPECT_TRUE(contains(refusal(chunk(5, 0, 6)), "ends too early"));
  EXPECT_TRUE(contains(refusal(chunk(1ULL << 40, 0, 5)), "claims 1099511627776 bytes"));
  EXPECT_TRUE(contains(refusal("short"), "ends too early"));
}

TEST(McapChunk, IsOpenedAsFarAsItGoes) {
  EXPECT_EQ(open_chunk(chunk(9, kCrcOfHello, 9), false), "hello");
}

}  // namespace
}  // namespace castaway::testbed
