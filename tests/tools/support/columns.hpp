// Reads the output of IntColumn.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tools/base/bytes/varint.hpp"

namespace castaway::testbed {

/// Numbers of a column.
inline std::vector<std::int64_t> column_values(std::string_view bytes) {
  std::vector<std::int64_t> values;
  std::int64_t last = 0;
  for (VarintReader reader(bytes); !reader.done();) {
    last += reader.next_signed();
    values.push_back(last);
  }
  return values;
}

}  // namespace castaway::testbed
