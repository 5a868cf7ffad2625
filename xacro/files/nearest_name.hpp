/// Finds the known name nearest to a misspelt one, for error texts.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace castaway {

/// Distance of F. J. Damerau ("A technique for computer detection and correction of spelling
/// errors", CACM 7, 1964): insertions, deletions and substitutions of one character, and swaps of
/// two neighbours, between which nothing else is edited.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The element of `known` with the smallest edit distance to `name`, the first one of a tie;
/// nothing if `known` is empty.
std::optional<std::string> nearest_name(std::string_view name,
                                        const std::vector<std::string>& known);

/// True if at most two characters, or a third of the name's, differ from what may be meant.
bool is_misspelling(std::string_view name, std::string_view meant);

/// "did you mean 'x'?", or some of the known names if none is similar.
std::string name_hint(std::string_view name, const std::vector<std::string>& known);

}  // namespace castaway
