/// Suggestions for misspelt names of settings and arguments.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// The known name nearest to `name`, if at most three edits change one to the other.
std::optional<std::string> close_name(std::string_view name, const std::vector<std::string>& known);

/// "did you mean 'x'?" for a near name, otherwise the list of the known names.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

}  // namespace castaway::testbed
