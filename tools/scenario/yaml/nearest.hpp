/// Finds the known name nearest to a misspelt one, for error texts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// Levenshtein distance: insertions, deletions and substitutions of one character.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The element of `known` with the smallest edit distance to `name`, the first one of a tie;
/// nothing if `known` is empty.
std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& known);

/// "did you mean 'x'?" for a near name, otherwise the list of the known names.
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

}  // namespace castaway::testbed
