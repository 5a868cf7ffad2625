#include "xacro/expression.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_files.hpp"

namespace castaway::xacro {
namespace {

using testing::HasSubstr;

/// a = 2, s = 'abc', d = {'x': {'y': 0.5}}, l = [1, 'two'], n.p = 7; f(x) returns 'f of x'.
Surroundings some_names() {
  Surroundings names;
  names.property = [](const std::string& name) -> std::optional<Value> {
    if (name == "a") return Value{std::int64_t{2}};
    if (name == "s") return Value{std::string("abc")};
    if (name == "n.p") return Value{std::int64_t{7}};
    if (name == "l") return Value{List{{std::int64_t{1}}, {std::string("two")}}};
    if (name == "d") return Value{Dict{{"x", {Dict{{"y", {0.5}}}}}}};
    return std::nullopt;
  };
  names.function = [](const std::string& name, const List& arguments) -> std::optional<Value> {
    if (name != "f") return std::nullopt;
    return Value{"f of " + to_text(arguments.at(0))};
  };
  return names;
}

std::string text_of(const std::string& expression) {
  return to_text(evaluate(expression, some_names()));
}

std::string error_of(const std::string& expression) {
  return error_text([&] { return evaluate(expression, some_names()); });
}

/// An expression and the value that Python prints.
struct Case {
  const char* expression;
  const char* text;
};

class Python : public testing::TestWithParam<Case> {};

TEST_P(Python, SaysTheSame) {
  EXPECT_EQ(text_of(GetParam().expression), GetParam().text) << GetParam().expression;
}

INSTANTIATE_TEST_SUITE_P(
    Arithmetic, Python,
    testing::Values(Case{"1 + 2 * 3", "7"}, Case{"(1 + 2) * 3", "9"}, Case{"7 / 2", "3.5"},
                    Case{"4 / 2", "2.0"}, Case{"7 // 2", "3"}, Case{"-7 // 2", "-4"},
                    Case{"-7 % 3", "2"}, Case{"7.5 // 2", "3.0"}, Case{"2 ** 10", "1024"},
                    Case{"2 ** -1", "0.5"}, Case{"-2 ** 2", "-4"}, Case{"2 ** 3 ** 2", "512"},
                    Case{"1 - 2 - 3", "-4"}, Case{"- -3", "3"}, Case{"+0.1", "0.1"},
                    Case{"0.1 + 0.2", "0.30000000000000004"}, Case{"1e-5", "1e-05"},
                    Case{"1.5e3", "1500.0"}, Case{".5 * 2", "1.0"}, Case{"True + 1", "2"},
                    Case{"a * 1.5", "3.0"},
                    Case{"9223372036854775807 + 1", "9.223372036854776e+18"},
                    Case{"n.p - a", "5"}));

INSTANTIATE_TEST_SUITE_P(
    Logic, Python,
    testing::Values(Case{"1 < 2 < 3", "True"}, Case{"1 < 2 > 5", "False"}, Case{"1 == 1.0", "True"},
                    Case{"'a' == \"a\"", "True"}, Case{"s == 'abc' and a == 2", "True"},
                    Case{"not a == 2 or False", "False"}, Case{"'x' != 'y'", "True"},
                    Case{"'b' in s", "True"}, Case{"'two' in l", "True"},
                    Case{"3 not in l", "True"}, Case{"'x' in d", "True"},
                    Case{"'big' if a > 1 else 'small'", "big"}, Case{"1 / 0 if False else 4", "4"},
                    Case{"0 or 'x'", "x"}, Case{"'' and 1", ""}, Case{"None is None", "True"},
                    Case{"not not 1", "True"}, Case{"'a' < 'b'", "True"},
                    Case{"'1' == 1", "False"}));

INSTANTIATE_TEST_SUITE_P(
    Functions, Python,
    testing::Values(Case{"sin(0)", "0.0"}, Case{"cos(pi)", "-1.0"}, Case{"math.sqrt(16)", "4.0"},
                    Case{"atan2(1, 1) * 4 == pi", "True"}, Case{"degrees(pi)", "180.0"},
                    Case{"radians(180) == math.pi", "True"}, Case{"min(3, 1, 2)", "1"},
                    Case{"max([1, 5])", "5"}, Case{"abs(-3)", "3"}, Case{"abs(-0.5)", "0.5"},
                    Case{"round(2.5)", "2"}, Case{"round(0.12345, 2)", "0.12"},
                    Case{"int(3.9)", "3"}, Case{"int('12')", "12"}, Case{"float('0.5')", "0.5"},
                    Case{"str(1) + '2'", "12"}, Case{"len(s)", "3"}, Case{"floor(-0.5)", "-1"},
                    Case{"ceil(0.2)", "1"}, Case{"bool('')", "False"}, Case{"f(a)", "f of 2"},
                    Case{"xacro.f(1)", "f of 1"}));

INSTANTIATE_TEST_SUITE_P(
    TextsAndContainers, Python,
    testing::Values(Case{"s + '_link'", "abc_link"}, Case{"'ab' * 2", "abab"},
                    Case{"s.upper()", "ABC"}, Case{"'a,b'.split(',')[1]", "b"},
                    Case{"' 1  2 '.split()", "['1', '2']"}, Case{"'x_link'.rstrip('_link')", "x"},
                    Case{"'aXbX'.replace('X', '-')", "a-b-"}, Case{"s.startswith('ab')", "True"},
                    Case{"l[-1]", "two"}, Case{"[1, 2] + [3]", "[1, 2, 3]"}, Case{"(1, 2)[0]", "1"},
                    Case{"{'k': 4}['k']", "4"}, Case{"d['x']['y']", "0.5"}, Case{"d.x.y", "0.5"},
                    Case{"dict(a=1, b='c')['b']", "c"}, Case{"d.get('z', 3)", "3"},
                    Case{"'it\\'s'", "it's"}, Case{"s[0]", "a"}, Case{"[]", "[]"}));

TEST(Expression, KeepsTypes) {
  EXPECT_TRUE(std::holds_alternative<std::int64_t>(evaluate("1 + 1", {}).data));
  EXPECT_TRUE(std::holds_alternative<double>(evaluate("1 / 1", {}).data));
  EXPECT_DOUBLE_EQ(to_double(evaluate("pi", some_names())), std::numbers::pi);
}

TEST(ExpressionErrors, SayWhatIsWrong) {
  EXPECT_THAT(error_of("unknown + 1"), HasSubstr("'unknown' is not defined"));
  EXPECT_THAT(error_of("1 +"), HasSubstr("incomplete"));
  EXPECT_THAT(error_of("(1"), HasSubstr("incomplete"));
  EXPECT_THAT(error_of("1 2"), HasSubstr("'2' is unexpected here"));
  EXPECT_THAT(error_of("a @ 2"), HasSubstr("'@'"));
  EXPECT_THAT(error_of("'open"), HasSubstr("closing quote"));
  EXPECT_THAT(error_of("1 / 0"), HasSubstr("division by zero"));
  EXPECT_THAT(error_of("s + 1"), HasSubstr("a text + an integer"));
  EXPECT_THAT(error_of("s * 'a'"), HasSubstr("has no meaning"));
  EXPECT_THAT(error_of("sqrt(-1)"), HasSubstr("sqrt"));
  EXPECT_THAT(error_of("sin()"), HasSubstr("sin() has 0 arguments"));
  EXPECT_THAT(error_of("l[5]"), HasSubstr("no entry 5"));
  EXPECT_THAT(error_of("d['z']"), HasSubstr("no entry 'z'"));
  EXPECT_THAT(error_of("open('/etc/passwd')"), HasSubstr("'open' is not supported"));
  EXPECT_THAT(error_of("[x for x in l]"), HasSubstr("'for' is unexpected here"));
  EXPECT_THAT(error_of("1.2.3"), HasSubstr("'1.2.3' is not a number"));
  EXPECT_THAT(error_of("s.format(1)"), HasSubstr("no method format()"));
  EXPECT_THAT(error_of(""), HasSubstr("incomplete"));
}

TEST(ExpressionErrors, RefuseWhatGrowsWithoutBounds) {
  EXPECT_THAT(error_of("'a' * 1000000000"), HasSubstr("65536"));
  EXPECT_THAT(error_of("10.0 ** 400"), HasSubstr("not a finite number"));
  EXPECT_THAT(error_of(std::string(200, '(') + "1" + std::string(200, ')')), HasSubstr("deeply"));
  EXPECT_THAT(error_of(std::string(500, '-') + "1"), HasSubstr("deeply"));
  EXPECT_THAT(error_of(std::string(5000, '1')), HasSubstr("4096"));
}

TEST(Literals, AreReadAsXacroReadsThem) {
  EXPECT_EQ(type_name(from_literal("12")), "an integer");
  EXPECT_EQ(type_name(from_literal(" -0.5 ")), "a float");
  EXPECT_EQ(type_name(from_literal("true")), "a bool");
  EXPECT_EQ(type_name(from_literal("1 2 3")), "a text");
  EXPECT_EQ(type_name(from_literal("1_000")), "a text");
  EXPECT_EQ(type_name(from_literal("inf")), "a text");
  EXPECT_EQ(to_text(from_literal("'007'")), "007");
}

TEST(Conditions, WantTruthOrANumber) {
  EXPECT_TRUE(condition({std::string("True")}));
  EXPECT_FALSE(condition({std::string("0")}));
  EXPECT_TRUE(condition({0.5}));
  EXPECT_FALSE(condition({List{}}));
  EXPECT_THROW((void)condition({std::string("maybe")}), std::invalid_argument);
  EXPECT_THROW((void)condition({std::string()}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::xacro
