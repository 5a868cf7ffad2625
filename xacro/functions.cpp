#include "xacro/functions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "xacro/operators.hpp"

namespace castaway::xacro {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_count(const std::string& name, const List& arguments, std::size_t least,
                  std::size_t most) {
  if (arguments.size() >= least && arguments.size() <= most) return;
  throw std::invalid_argument(
      fmt::format("{}() has {} arguments; needs {}", name, arguments.size(),
                  least == most ? std::to_string(least) : fmt::format("{} to {}", least, most)));
}

double finite(const std::string& name, double result) {
  if (std::isfinite(result)) return result;
  throw std::invalid_argument(fmt::format("{}() of this argument is not a finite number", name));
}

using Function1 = double (*)(double);
using Function2 = double (*)(double, double);

const std::map<std::string, Function1>& functions_of_one() {
  static const std::map<std::string, Function1> kFunctions{
      {"sin", [](double x) { return std::sin(x); }},
      {"cos", [](double x) { return std::cos(x); }},
      {"tan", [](double x) { return std::tan(x); }},
      {"asin", [](double x) { return std::asin(x); }},
      {"acos", [](double x) { return std::acos(x); }},
      {"atan", [](double x) { return std::atan(x); }},
      {"sqrt", [](double x) { return std::sqrt(x); }},
      {"exp", [](double x) { return std::exp(x); }},
      {"log", [](double x) { return std::log(x); }},
      {"fabs", [](double x) { return std::abs(x); }},
      {"radians", [](double x) { return x * kPi / 180.0; }},
      {"degrees", [](double x) { return x * 180.0 / kPi; }}};
  return kFunctions;
}

const std::map<std::string, Function2>& functions_of_two() {
  static const std::map<std::string, Function2> kFunctions{
      {"atan2", [](double y, double x) { return std::atan2(y, x); }},
      {"hypot", [](double x, double y) { return std::hypot(x, y); }},
      {"pow", [](double x, double y) { return std::pow(x, y); }}};
  return kFunctions;
}

Value integer_value(double number) {
  if (std::abs(number) > 1e15) return {number};
  return {static_cast<std::int64_t>(number)};
}

Value to_int(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  const Value number = text != nullptr ? from_literal(*text) : value;
  const bool from_float_text = text != nullptr && std::holds_alternative<double>(number.data);
  if (!is_number(number) || from_float_text) {
    throw std::invalid_argument(fmt::format("int() of '{}'", to_text(value)));
  }
  return integer_value(std::trunc(to_double(number)));
}

Value to_float(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  const Value number = text != nullptr ? from_literal(*text) : value;
  if (!is_number(number))
    throw std::invalid_argument(fmt::format("float() of '{}'", to_text(value)));
  return {to_double(number)};
}

/// Rounds half to even, as Python does.
Value round_value(const List& arguments) {
  expect_count("round", arguments, 1, 2);
  const double number = to_double(arguments[0]);
  if (arguments.size() == 1) return integer_value(std::nearbyint(number));
  const double scale = std::pow(10.0, static_cast<double>(to_integer(arguments[1])));
  return {finite("round", std::nearbyint(number * scale) / scale)};
}

Value extreme(const std::string& name, const List& arguments) {
  const bool of_list = arguments.size() == 1 && std::holds_alternative<List>(arguments[0].data);
  const List& items = of_list ? std::get<List>(arguments[0].data) : arguments;
  if (items.empty()) throw std::invalid_argument(name + "() of nothing");
  const std::string sign = name == "min" ? "<" : ">";
  const Value* best = &items[0];
  for (const Value& item : items) {
    if (truth(binary(sign, item, *best))) best = &item;
  }
  return *best;
}

std::int64_t length(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) {
    return static_cast<std::int64_t>(text->size());
  }
  if (const auto* list = std::get_if<List>(&value.data)) {
    return static_cast<std::int64_t>(list->size());
  }
  if (const auto* dict = std::get_if<Dict>(&value.data)) {
    return static_cast<std::int64_t>(dict->size());
  }
  throw std::invalid_argument(fmt::format("len() of {}", type_name(value)));
}

/// Calls a conversion or similar function of one argument; nothing for other names.
std::optional<Value> convert(const std::string& name, const Value& x) {
  if (name == "int") return to_int(x);
  if (name == "float") return to_float(x);
  if (name == "str") return Value{to_text(x)};
  if (name == "bool") return Value{truth(x)};
  if (name == "len") return Value{length(x)};
  if (name == "list" && std::holds_alternative<List>(x.data)) return x;
  if (name == "floor") return integer_value(std::floor(to_double(x)));
  if (name == "ceil") return integer_value(std::ceil(to_double(x)));
  if (name == "abs") return to_double(x) < 0.0 ? unary("-", x) : x;
  return std::nullopt;
}

}  // namespace

std::optional<Value> constant(const std::string& name) {
  if (name == "pi") return Value{kPi};
  if (name == "tau") return Value{2.0 * kPi};
  if (name == "e") return Value{std::numbers::e};
  return std::nullopt;
}

std::optional<Value> call_function(const std::string& name, const List& arguments) {
  if (const auto one = functions_of_one().find(name); one != functions_of_one().end()) {
    expect_count(name, arguments, 1, 1);
    return Value{finite(name, one->second(to_double(arguments[0])))};
  }
  if (const auto two = functions_of_two().find(name); two != functions_of_two().end()) {
    expect_count(name, arguments, 2, 2);
    return Value{finite(name, two->second(to_double(arguments[0]), to_double(arguments[1])))};
  }
  if (name == "min" || name == "max") return extreme(name, arguments);
  if (name == "round") return round_value(arguments);
  for (const char* conversion :
       {"int", "float", "str", "bool", "len", "list", "floor", "ceil", "abs"}) {
    if (name != conversion) continue;
    expect_count(name, arguments, 1, 1);
    return convert(name, arguments[0]);
  }
  return std::nullopt;
}

}  // namespace castaway::xacro
