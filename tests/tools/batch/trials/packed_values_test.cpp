#include "tools/batch/trials/packed_values.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

double sent_on(double value) {
  return unpacked_double(nlohmann::ordered_json::parse(packed(value).dump()));
}

TEST(PackedValues, KeepEveryBitOfANumber) {
  const std::vector<double> values = {0.1, 1.0 / 3.0, -0.0, 1e-310,
                                      std::numeric_limits<double>::max()};
  for (const double value : values) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(sent_on(value)), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(PackedValues, KeepNumbersThatAreNotFinite) {
  EXPECT_EQ(sent_on(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(sent_on(-std::numeric_limits<double>::infinity()),
            -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(sent_on(std::numeric_limits<double>::quiet_NaN())));
}

TEST(PackedValues, TellNothingFromZero) {
  EXPECT_FALSE(unpacked_number(packed(std::optional<double>())));
  EXPECT_EQ(unpacked_number(packed(std::optional(0.0))), 0.0);
}

TEST(PackedValues, RefuseOtherJson) {
  EXPECT_THROW(unpacked_double(nlohmann::ordered_json::array()), nlohmann::json::exception);
}

}  // namespace
}  // namespace castaway::testbed
