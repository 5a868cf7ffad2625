#include "xacro/parameters.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::xacro {
namespace {

TEST(Parameters, OfEveryForm) {
  const auto p = parse_parameters("a b:=1\n c:='x y' d:=^ e:=^|2 *block **content f=3 g:=${1 + 2}");
  ASSERT_EQ(p.size(), 9U);
  EXPECT_EQ(p[0].name, "a");
  EXPECT_FALSE(p[0].fallback.has_value());
  EXPECT_EQ(p[1].fallback, "1");
  EXPECT_EQ(p[2].fallback, "x y");
  EXPECT_TRUE(p[3].from_outside);
  EXPECT_FALSE(p[3].fallback.has_value());
  EXPECT_TRUE(p[4].from_outside);
  EXPECT_EQ(p[4].fallback, "2");
  EXPECT_EQ(p[5].kind, Parameter::Kind::kBlock);
  EXPECT_EQ(p[5].name, "block");
  EXPECT_EQ(p[6].kind, Parameter::Kind::kContent);
  EXPECT_EQ(p[6].name, "content");
  EXPECT_EQ(p[7].fallback, "3");
  EXPECT_EQ(p[8].fallback, "${1 + 2}");
}

TEST(Parameters, FromOutsideHaveADefaultWithOrWithoutABar) {
  for (const char* text : {"gpu:=^true", "gpu:=^|true", "gpu:=^'true'"}) {
    const auto p = parse_parameters(text);
    EXPECT_TRUE(p.at(0).from_outside) << text;
    EXPECT_EQ(p.at(0).fallback, "true") << text;
  }
}

TEST(Parameters, NoneAndEmptyDefaults) {
  EXPECT_TRUE(parse_parameters("").empty());
  EXPECT_EQ(parse_parameters("a:=''").at(0).fallback, "");
  EXPECT_EQ(parse_parameters("a:=").at(0).fallback, "");
}

TEST(Parameters, ThatMakeNoSenseAreRefused) {
  for (const char* text : {"a a", "***a", "*", "*a:=1", "a:='x", ":=1", "a:=^'b"}) {
    EXPECT_THROW(parse_parameters(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace castaway::xacro
