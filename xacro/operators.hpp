/// Operators of xacro expressions on values, as Python defines them.
#pragma once

#include <string>

#include "xacro/value.hpp"

namespace castaway::xacro {

/// Computes `a <sign> b` for + - * / // % ** == != < <= > >= in, "not in". Integers that overflow
/// become floats; texts longer than 65536 characters and large lists are refused.
/// @throws std::invalid_argument naming operator and types if the operation is undefined.
Value binary(const std::string& sign, const Value& a, const Value& b);

/// Computes `-a` or `+a`. @throws std::invalid_argument if `a` is not a number.
Value unary(const std::string& sign, const Value& a);

/// `container[index]` for lists (negative: from the end), texts and dictionaries.
/// @throws std::invalid_argument if there is no such entry.
Value index(const Value& container, const Value& key);

}  // namespace castaway::xacro
