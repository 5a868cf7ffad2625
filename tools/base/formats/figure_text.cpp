#include "tools/base/formats/figure_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {

using Json = nlohmann::ordered_json;

std::string figure_text(const Json& value, const char* format, double factor) {
  return value.is_number() ? fmt::format(fmt::runtime(format), factor * value.get<double>()) : "-";
}

std::string figure_text(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string interval_text(const Json& ends, const char* format, double factor) {
  if (!ends.is_array()) return "";
  return fmt::format(" [{}, {}]", figure_text(ends.at(0), format, factor),
                     figure_text(ends.at(1), format, factor));
}

}  // namespace castaway::testbed
