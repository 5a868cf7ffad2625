#include "tools/base/bytes/compression.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

class PackedChunk : public testing::TestWithParam<Compression> {
 protected:
  [[nodiscard]] static std::string text() {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += std::to_string(i * 7919 % 1000003);
    return text;
  }
};

TEST_P(PackedChunk, BringsBackWhatItPacked) {
  for (const std::string& bytes : {std::string("a"), std::string(1'000'000, 'a'), text()}) {
    const std::string packed = pack_chunk(bytes, GetParam());
    const UnpackedChunk chunk = unpack_chunk(packed, compression_name(GetParam()), bytes.size());
    EXPECT_TRUE(chunk.whole);
    EXPECT_EQ(chunk.bytes, bytes);
  }
}

TEST_P(PackedChunk, UnpacksTheFrontOfACutFrame) {
  const std::string bytes = text();
  const std::string packed = pack_chunk(bytes, GetParam());
  const UnpackedChunk chunk = unpack_chunk(packed.substr(0, packed.size() * 9 / 10),
                                           compression_name(GetParam()), bytes.size());
  EXPECT_EQ(chunk.whole, GetParam() == Compression::kNone);
  EXPECT_GT(chunk.bytes.size(), bytes.size() / 3);
  EXPECT_EQ(chunk.bytes, bytes.substr(0, chunk.bytes.size()));
}

TEST_P(PackedChunk, StopsAtTheMostThatItMayMake) {
  const std::string packed = pack_chunk(std::string(50'000'000, 'a'), GetParam());
  EXPECT_TRUE(contains(error_of([&] { unpack_chunk(packed, compression_name(GetParam()), 1000); }),
                       "than the 1000 bytes"));
}

INSTANTIATE_TEST_SUITE_P(All, PackedChunk,
                         testing::Values(Compression::kNone, Compression::kZstd,
                                         Compression::kLz4));

TEST(PackedChunk, PacksNothingIntoAFrame) {
  for (const auto compression : {Compression::kZstd, Compression::kLz4}) {
    const UnpackedChunk chunk =
        unpack_chunk(pack_chunk("", compression), compression_name(compression), 0);
    EXPECT_EQ(chunk.bytes, "");
    EXPECT_TRUE(chunk.whole);
  }
}

}  // namespace
}  // namespace castaway::testbed
