/// Values of xacro expressions: Python's, as far as robot descriptions use them.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace castaway::sim::xacro {

struct Value;
struct DictEntry;
using List = std::vector<Value>;
using Dict = std::vector<DictEntry>;  ///< In the order of insertion, as Python keeps it.

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

/// `str(value)`: integers without, floats with a point, texts as they are.
std::string to_text(const Value& value);

/// Text of a property or of a macro's argument as a value: an integer, a float, true or false, a
/// quoted text without its quotes, else the text itself.
Value from_literal(const std::string& text);

/// Python's truth of a value: zeros and what is empty are false.
bool truth(const Value& value);

/// Truth of a condition's value: a text must say true, false or a whole number.
/// @throws std::invalid_argument if it does not.
bool condition(const Value& value);

/// True for integers, floats and booleans.
bool is_number(const Value& value);

/// @throws std::invalid_argument if the value is no number.
double to_double(const Value& value);

/// @throws std::invalid_argument if the value is no integer or boolean.
std::int64_t to_integer(const Value& value);

/// Python's `==`: numbers by value, whatever their types.
bool equal(const Value& a, const Value& b);

/// The value, if it is not too large: lists in lists grow fast.
/// @throws std::invalid_argument if it holds more than 200000 items and characters.
Value bounded(Value value);

/// The entry of a key; null if there is none.
const Value* find_key(const Dict& dict, const std::string& key);

}  // namespace castaway::sim::xacro
