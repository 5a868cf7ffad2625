/// Operators of xacro expressions on values, as Python defines them.
#pragma once

#include <string>

#include "sim/xacro/value.hpp"

namespace castaway::sim::xacro {

/// `a <sign> b` for + - * / // % ** == != < <= > >= in, "not in". Integers that overflow become
/// floats; texts longer than 65536 characters and large lists are refused.
/// @throws std::invalid_argument naming the operator and the types where it has no meaning.
Value binary(const std::string& sign, const Value& a, const Value& b);

/// `-a` or `+a`. @throws std::invalid_argument if it is no number.
Value unary(const std::string& sign, const Value& a);

/// `container[index]` of lists (from the end if negative), texts and dictionaries.
/// @throws std::invalid_argument if there is no such entry.
Value index(const Value& container, const Value& key);

}  // namespace castaway::sim::xacro
