#include "tools/batch/trials/packed_values.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tools/run/localizer_failure.hpp"

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

TEST(PackedValues, PassATrialOn) {
  EXPECT_EQ(unpacked_trial(packed_trial([] { return std::string("two\nlines"); })), "two\nlines");
}

TEST(PackedValues, PassTheFailureOfALocalizerOnAndNoOther) {
  const std::string answer = packed_trial([]() -> std::string { throw LocalizerFailure("died"); });
  try {
    unpacked_trial(answer);
    FAIL() << "no failure";
  } catch (const LocalizerFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("died"), std::string::npos);
  }
  EXPECT_THROW(packed_trial([]() -> std::string { throw std::runtime_error("broken"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
