#include "tools/base/formats/points/scalar.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/base/formats/points/cloud_bytes.hpp"

namespace castaway::testbed {
namespace {

using enum ScalarKind;

/// The number that `scalar_at` reads from the bytes of `value`, in both orders of bytes.
template <typename T>
double read_back(T value, ScalarKind kind) {
  const ScalarType type{kind, sizeof(T)};
  const double little = scalar_at(bytes_of(value) + "rest", type, std::endian::little);
  const double big = scalar_at(bytes_of(value, std::endian::big) + "rest", type, std::endian::big);
  EXPECT_EQ(little, big);
  return little;
}

TEST(Scalar, ReadsAllTypesInBothByteOrders) {
  EXPECT_EQ(read_back(-2.5F, kFloat), -2.5);
  EXPECT_EQ(read_back(0.1, kFloat), 0.1);
  EXPECT_EQ(read_back(std::int8_t{-128}, kSigned), -128.0);
  EXPECT_EQ(read_back(std::int16_t{-2}, kSigned), -2.0);
  EXPECT_EQ(read_back(std::int32_t{-70000}, kSigned), -70000.0);
  EXPECT_EQ(read_back(std::int64_t{-5000000000}, kSigned), -5e9);
  EXPECT_EQ(read_back(std::uint8_t{255}, kUnsigned), 255.0);
  EXPECT_EQ(read_back(std::uint16_t{0x0102}, kUnsigned), 258.0);
  EXPECT_EQ(read_back(std::uint32_t{4000000000}, kUnsigned), 4e9);
  EXPECT_EQ(read_back(std::uint64_t{1} << 63U, kUnsigned), std::ldexp(1.0, 63));
}

TEST(Scalar, ParsesWholeWordsOnly) {
  EXPECT_EQ(parse_scalar("-1.5e1"), -15.0);
  EXPECT_EQ(parse_scalar("+2"), 2.0);
  EXPECT_TRUE(std::isnan(parse_scalar("nan").value()));
  EXPECT_TRUE(std::isinf(parse_scalar("-inf").value()));
  for (const char* word : {"", "+", "+-1", "1x", "1,5", "x"}) {
    EXPECT_FALSE(parse_scalar(word).has_value()) << word;
  }
}

TEST(Scalar, ParsesCountsBelowTwoToTheThirtySecond) {
  EXPECT_EQ(parse_count("4294967295"), 4294967295U);
  for (const char* word : {"", "-1", "1.0", "4294967296", "3x"}) {
    EXPECT_FALSE(parse_count(word).has_value()) << word;
  }
}

}  // namespace
}  // namespace castaway::testbed
