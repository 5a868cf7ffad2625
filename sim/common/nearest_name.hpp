/// Suggestions for misspelt names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace castaway::sim {

/// "did you mean 'x'?", or some of the known names if none is similar.
std::string name_hint(std::string_view name, const std::vector<std::string>& known);

}  // namespace castaway::sim
