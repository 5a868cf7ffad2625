#include "tools/base/formats/points/lzf.hpp"

#include <gtest/gtest.h>

#include "tests/tools/base/formats/points/cloud_bytes.hpp"

namespace castaway::testbed {
namespace {

TEST(Lzf, CopiesLiteralRuns) {
  const std::string text(100, 'q');
  EXPECT_EQ(decompress_lzf(lzf_literals(text), 100), text);
  EXPECT_EQ(decompress_lzf("", 0), "");
}

TEST(Lzf, RepeatsWhatItHasJustWritten) {
  // A literal run of 2, then 7 bytes from 2 bytes ago: control byte 5 << 5, offset 1.
  EXPECT_EQ(decompress_lzf(std::string("\x01"
                                       "ab\xa0\x01",
                                       5),
                           9),
            "ababababa");
  EXPECT_EQ(decompress_lzf(lzf_literals("abc") + lzf_match(3, 3), 6), "abcabc");
}

TEST(Lzf, ReadsLongMatchesFromFarAgo) {
  const std::string far = "begin" + std::string(8187, '.');
  EXPECT_EQ(decompress_lzf(lzf_literals(far) + lzf_match(264, 8192), 8192 + 264),
            far + "begin" + std::string(259, '.'));
  EXPECT_EQ(decompress_lzf(lzf_literals("a") + lzf_match(9, 1), 10), std::string(10, 'a'));
}

TEST(Lzf, RefusesDamage) {
  const std::string packed = lzf_literals("abc") + lzf_match(20, 3);
  ASSERT_TRUE(decompress_lzf(packed, 23).has_value());
  EXPECT_FALSE(decompress_lzf(packed, 22).has_value());
  EXPECT_FALSE(decompress_lzf(packed, 24).has_value());
  for (std::size_t size = 0; size < packed.size(); ++size) {
    EXPECT_FALSE(decompress_lzf(packed.substr(0, size), 23).has_value()) << size;
  }
  EXPECT_FALSE(decompress_lzf(lzf_literals("abc") + lzf_match(20, 4), 23).has_value());
}

TEST(Lzf, ReservesNoMemoryForAnAbsurdSize) {
  EXPECT_FALSE(decompress_lzf(lzf_literals("abc"), std::size_t{1} << 60U).has_value());
}

}  // namespace
}  // namespace castaway::testbed
