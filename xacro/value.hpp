/// Values of xacro expressions: the subset of Python's that robot descriptions use.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace castaway::xacro {

struct Value;
struct DictEntry;
using List = std::vector<Value>;
using Dict = std::vector<DictEntry>;  ///< In order of insertion, as in Python.

/// One value; the first alternative is None.
struct Value {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Dict> data;
};

/// A key and its value.
struct DictEntry {
  std::string key;
  Value value;
};

/// The type's name in Python, for errors.
std::string type_name(const Value& value);

/// Python's `str(value)`: floats have a decimal point, texts are unchanged.
std::string to_text(const Value& value);

/// The value of a property's or macro argument's text: an integer, a float, true or false, a quoted
/// text without its quotes, or else the text itself.
Value from_literal(const std::string& text);

/// Python's truth value: zeros and empty values are false.
bool truth(const Value& value);

/// Truth value of a condition: a text must be true, false or an integer.
/// @throws std::invalid_argument otherwise.
bool condition(const Value& value);

/// True for integers, floats and booleans.
bool is_number(const Value& value);

/// @throws std::invalid_argument if the value is not a number.
double to_double(const Value& value);

/// @throws std::invalid_argument if the value is not an integer or boolean.
std::int64_t to_integer(const Value& value);

/// Python's `==`: numbers are compared by value, regardless of type.
bool equal(const Value& a, const Value& b);

/// Returns the value if it is not too large: nested lists grow fast.
/// @throws std::invalid_argument if it has more than 200000 items and characters.
Value check_size(Value value);

/// The value of a key; nullptr if there is none.
const Value* find_key(const Dict& dict, const std::string& key);

}  // namespace castaway::xacro
