/// Reads integers from JSON of unknown origin.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <utility>

#include <nlohmann/json_fwd.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {

/// Reads an integer. Throws Json::out_of_range if it has a fraction or does not fit into T, for
/// which `get` is undefined; Json::type_error if it is not a number.
template <std::integral T, typename Json>
T integer(const Json& value) {
  if (value.is_number_float()) {
    const double number = value.template get<double>();
    const double limit = std::ldexp(1.0, std::numeric_limits<T>::digits);
    const double low = std::is_signed_v<T> ? -limit : 0.0;
    if (number >= low && number < limit && number == std::floor(number)) {
      return static_cast<T>(number);
    }
  } else if (value.is_number_unsigned()) {
    const auto number = value.template get<std::uint64_t>();
    if (std::in_range<T>(number)) return static_cast<T>(number);
  } else {
    const auto number = value.template get<std::int64_t>();
    if (std::in_range<T>(number)) return static_cast<T>(number);
  }
  throw Json::out_of_range::create(406, json_text(value) + " is not an integer or does not fit",
                                   &value);
}

/// Reads the integer under a key of an object, or `fallback` if the key is missing.
template <std::integral T, typename Json>
T integer_or(const Json& object, const std::string& key, T fallback) {
  const auto found = object.find(key);
  return found == object.end() ? fallback : integer<T>(*found);
}

}  // namespace castaway::testbed
