#include "tools/scenario/yaml/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "xacro/files/nearest_name.hpp"

namespace castaway::testbed {

std::optional<std::string> close_name(std::string_view name,
                                      const std::vector<std::string>& known) {
  std::optional<std::string> nearest = nearest_name(name, known);
  if (nearest && edit_distance(name, *nearest) > 3) nearest.reset();
  return nearest;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known) {
  const std::optional<std::string> nearest = nearest_name(name, known);
  if (!nearest) return "no name is known here";
  if (is_misspelling(name, *nearest)) return fmt::format("did you mean '{}'?", *nearest);
  return fmt::format("nearest is '{}'; known are: {}", *nearest, fmt::join(known, ", "));
}

}  // namespace castaway::testbed
