#include "xacro/operators.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::xacro {
namespace {

constexpr std::size_t kMaxLength = 65536;

bool is_integer(const Value& v) {
  return std::holds_alternative<std::int64_t>(v.data) || std::holds_alternative<bool>(v.data);
}

[[noreturn]] void meaningless(const std::string& sign, const Value& a, const Value& b) {
  throw std::invalid_argument(fmt::format("{} {} {} has no meaning ('{}', '{}')", type_name(a),
                                          sign, type_name(b), to_text(a), to_text(b)));
}

/// Rounds down like Python, not towards zero.
std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

std::optional<Value> integer_power(std::int64_t a, std::int64_t b) {
  if (b < 0) return std::nullopt;
  const double power = std::pow(static_cast<double>(a), static_cast<double>(b));
  if (std::abs(power) > 1e15) return std::nullopt;
  return Value{static_cast<std::int64_t>(power)};
}

/// The result of + - * // % ** in integers; nothing if it is not an integer.
std::optional<Value> in_integers(const std::string& sign, std::int64_t a, std::int64_t b) {
  if (sign == "**") return integer_power(a, b);
  std::int64_t result = 0;
  bool overflow = false;
  if (sign == "+") {
    overflow = __builtin_add_overflow(a, b, &result);
  } else if (sign == "-") {
    overflow = __builtin_sub_overflow(a, b, &result);
  } else if (sign == "*") {
    overflow = __builtin_mul_overflow(a, b, &result);
  } else if ((sign == "//" || sign == "%") && b != 0 && b != -1) {
    result = sign == "//" ? floor_div(a, b) : a - b * floor_div(a, b);
  } else {
    return std::nullopt;
  }
  if (overflow) return std::nullopt;
  return Value{result};
}

double in_doubles(const std::string& sign, double a, double b) {
  if (sign == "+") return a + b;
  if (sign == "-") return a - b;
  if (sign == "*") return a * b;
  if (sign == "/") return a / b;
  if (sign == "//") return std::floor(a / b);
  if (sign == "%") return a - b * std::floor(a / b);
  if (sign == "**") return std::pow(a, b);
  return 0.0;
}

Value arithmetic(const std::string& sign, const Value& left, const Value& right) {
  if (is_integer(left) && is_integer(right)) {
    if (auto result = in_integers(sign, to_integer(left), to_integer(right))) return *result;
  }
  const double a = to_double(left);
  const double b = to_double(right);
  if (b == 0.0 && (sign == "/" || sign == "//" || sign == "%")) {
    throw std::invalid_argument("division by zero");
  }
  const double result = in_doubles(sign, a, b);
  if (!std::isfinite(result)) {
    throw std::invalid_argument(fmt::format("{} {} {} is not a finite number", a, sign, b));
  }
  return {result};
}

/// Concatenates two texts or two lists; nothing for other types.
std::optional<Value> concatenation(const Value& a, const Value& b) {
  if (a.data.index() != b.data.index()) return std::nullopt;
  if (const auto* text = std::get_if<std::string>(&a.data)) {
    return Value{*text + std::get<std::string>(b.data)};
  }
  const auto* list = std::get_if<List>(&a.data);
  if (list == nullptr) return std::nullopt;
  List sum = *list;
  for (const Value& item : std::get<List>(b.data)) sum.push_back(item);
  return Value{sum};
}

/// A text repeated; nothing for other types.
std::optional<Value> repetition(const Value& a, const Value& b) {
  const auto* text = std::get_if<std::string>(&a.data);
  if (text == nullptr || !is_integer(b)) return std::nullopt;
  const auto count = static_cast<std::uint64_t>(std::max<std::int64_t>(to_integer(b), 0));
  if (count * text->size() > kMaxLength || count > kMaxLength) {
    throw std::invalid_argument(fmt::format("a text longer than {} characters", kMaxLength));
  }
  std::string repeated;
  for (std::uint64_t i = 0; i < count; ++i) repeated += *text;
  return Value{repeated};
}

std::optional<Value> join_or_repeat(const std::string& sign, const Value& a, const Value& b) {
  if (sign == "+") return concatenation(a, b);
  return sign == "*" ? repetition(a, b) : std::nullopt;
}

Value check_length(Value value) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr || text->size() <= kMaxLength) return check_size(std::move(value));
  throw std::invalid_argument(fmt::format("a text longer than {} characters", kMaxLength));
}

/// Negative, zero or positive if a is less than, equal to or greater than b.
int order(const std::string& sign, const Value& a, const Value& b) {
  if (is_number(a) && is_number(b)) {
    const double difference = to_double(a) - to_double(b);
    return difference < 0.0 ? -1 : difference > 0.0 ? 1 : 0;
  }
  const auto* left = std::get_if<std::string>(&a.data);
  const auto* right = std::get_if<std::string>(&b.data);
  if (left == nullptr || right == nullptr) meaningless(sign, a, b);
  return left->compare(*right);
}

bool contains(const Value& container, const Value& item) {
  if (const auto* list = std::get_if<List>(&container.data)) {
    return std::any_of(list->begin(), list->end(), [&](const Value& v) { return equal(v, item); });
  }
  if (const auto* dict = std::get_if<Dict>(&container.data)) {
    return find_key(*dict, to_text(item)) != nullptr;
  }
  const auto* text = std::get_if<std::string>(&container.data);
  const auto* part = std::get_if<std::string>(&item.data);
  if (text == nullptr || part == nullptr) meaningless("in", item, container);
  return text->find(*part) != std::string::npos;
}

std::size_t position(const Value& key, std::size_t size) {
  const std::int64_t asked = to_integer(key);
  const auto count = static_cast<std::int64_t>(size);
  const std::int64_t from_start = asked < 0 ? asked + count : asked;
  if (from_start < 0 || from_start >= count) {
    throw std::invalid_argument(fmt::format("no entry {} among {}", asked, size));
  }
  return static_cast<std::size_t>(from_start);
}

}  // namespace

Value binary(const std::string& sign, const Value& a, const Value& b) {
  if (sign == "==") return {equal(a, b)};
  if (sign == "!=") return {!equal(a, b)};
  if (sign == "in") return {contains(b, a)};
  if (sign == "not in") return {!contains(b, a)};
  if (sign == "<") return {order(sign, a, b) < 0};
  if (sign == "<=") return {order(sign, a, b) <= 0};
  if (sign == ">") return {order(sign, a, b) > 0};
  if (sign == ">=") return {order(sign, a, b) >= 0};
  if (is_number(a) && is_number(b)) return arithmetic(sign, a, b);
  if (auto result = join_or_repeat(sign, a, b)) return check_length(std::move(*result));
  meaningless(sign, a, b);
}

Value unary(const std::string& sign, const Value& a) {
  if (sign == "+") return binary("+", {std::int64_t{0}}, a);
  return is_integer(a) ? binary("-", {std::int64_t{0}}, a) : Value{-to_double(a)};
}

Value index(const Value& container, const Value& key) {
  if (const auto* list = std::get_if<List>(&container.data)) {
    return (*list)[position(key, list->size())];
  }
  if (const auto* text = std::get_if<std::string>(&container.data)) {
    return {std::string(1, (*text)[position(key, text->size())])};
  }
  const auto* dict = std::get_if<Dict>(&container.data);
  if (dict == nullptr) {
    throw std::invalid_argument(fmt::format("{} has no entries", type_name(container)));
  }
  if (const Value* value = find_key(*dict, to_text(key))) return *value;
  throw std::invalid_argument(fmt::format("no entry '{}' in the dictionary", to_text(key)));
}

}  // namespace castaway::xacro
