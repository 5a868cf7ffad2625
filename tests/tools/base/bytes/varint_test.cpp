#include "tools/base/bytes/varint.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/columns.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using std::string_literals::operator""s;

std::string signed_bytes(std::int64_t value) {
  std::string bytes;
  append_signed(bytes, value);
  return bytes;
}

TEST(Varint, TakesSevenBitsAByteLowestFirst) {
  std::string bytes;
  for (const std::uint64_t value : {0U, 1U, 127U, 128U, 300U}) append_varint(bytes, value);
  EXPECT_EQ(bytes, "\x00\x01\x7f\x80\x01\xac\x02"s);
}

TEST(Varint, PutsSmallNegativeNumbersIntoAByte) {
  EXPECT_EQ(signed_bytes(0), "\x00"s);
  EXPECT_EQ(signed_bytes(-1), "\x01"s);
  EXPECT_EQ(signed_bytes(1), "\x02"s);
  EXPECT_EQ(signed_bytes(-64), "\x7f"s);
  EXPECT_EQ(signed_bytes(64), "\x80\x01"s);
}

TEST(Varint, ReadsEveryNumberBack) {
  using Limits = std::numeric_limits<std::int64_t>;
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-300}, std::int64_t{1} << 40U,
                                   Limits::min(), Limits::max()}) {
    const std::string bytes = signed_bytes(value);
    VarintReader reader(bytes);
    EXPECT_EQ(reader.next_signed(), value);
    EXPECT_TRUE(reader.done());
  }
}

TEST(Varint, RefusesWhatEndsWithinANumberOrNever) {
  EXPECT_TRUE(contains(error_of([] { VarintReader("\x80").next(); }), "end within"));
  const std::string endless(11, '\xff');
  EXPECT_TRUE(contains(error_of([&] { VarintReader(endless).next(); }), "64 bits"));
}

TEST(Quantized, RoundsAndKeepsClearOfWhatIsNoNumber) {
  EXPECT_EQ(quantize(1.26, 0.1), 13);
  EXPECT_EQ(quantize(-1.26, 0.1), -13);
  EXPECT_EQ(quantize(std::nan(""), 0.1), 0);
  EXPECT_EQ(quantize(std::numeric_limits<double>::infinity(), 0.1), std::int64_t{1} << 50U);
  EXPECT_EQ(quantize(-1e300, 0.1), -(std::int64_t{1} << 50U));
}

TEST(IntColumn, KeepsDifferences) {
  IntColumn column;
  column.add(1000);
  column.add(1001);
  column.repeat();
  column.add(999);
  EXPECT_EQ(column.bytes(), signed_bytes(1000) + "\x02\x00\x03"s);
  EXPECT_EQ(column_values(column.bytes()), (std::vector<std::int64_t>{1000, 1001, 1001, 999}));
}

}  // namespace
}  // namespace castaway::testbed
