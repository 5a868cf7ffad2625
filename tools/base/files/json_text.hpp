/// Writes JSON as text.
#pragma once

#include <string>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {

/// JSON as text, on one line or indented. Bytes that are not UTF-8, as in a file's name, become
/// U+FFFD: a figure that took hours must not be lost for a name.
template <typename Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace castaway::testbed
