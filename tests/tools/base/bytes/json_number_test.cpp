#include "tools/base/bytes/json_number.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

TEST(Whole, TakesWhatFits) {
  EXPECT_EQ(integer<int>(Json::parse("-2147483648")), std::numeric_limits<int>::min());
  EXPECT_EQ(integer<int>(Json::parse("7.0")), 7);
  EXPECT_EQ(integer<std::uint64_t>(Json::parse("18446744073709551615")),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(integer<std::int64_t>(Json::parse("1e18")), 1000000000000000000);
}

TEST(Whole, RefusesWhatDoesNot) {
  for (const char* text : {"2147483648", "-2147483649", "1e10", "1e300", "-1e300", "1.5",
                           "18446744073709551615", "99999999999999999999"}) {
    EXPECT_THROW(integer<int>(Json::parse(text)), Json::out_of_range) << text;
  }
  EXPECT_THROW(integer<std::uint64_t>(Json::parse("-1")), Json::out_of_range);
  EXPECT_THROW(integer<std::uint64_t>(Json::parse("9.99778e+20")), Json::out_of_range);
  EXPECT_THROW(integer<std::int64_t>(Json::parse("9223372036854775808.0")), Json::out_of_range);
  EXPECT_THROW(integer<int>(Json::parse("\"7\"")), Json::type_error);
}

TEST(Whole, StandsInWhereThereIsNone) {
  const Json object = Json::parse(R"({"a": 3, "b": 1e300})");
  EXPECT_EQ(integer_or(object, "a", 5), 3);
  EXPECT_EQ(integer_or(object, "c", 5), 5);
  EXPECT_THROW(integer_or(object, "b", 5), Json::out_of_range);
}

}  // namespace
}  // namespace castaway::testbed
