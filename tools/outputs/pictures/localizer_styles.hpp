/// Which colour, dashes and outline a localizer has on every page, picture and film.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Index into the palette of each localizer, 0 to 5. It follows from the name, so that a localizer
/// looks the same in every run; names that would share a colour in one list take the next free one.
/// More than six share colours. `stylesOf` of web/src/palette.js is the same function.
std::vector<std::size_t> localizer_styles(const std::vector<std::string>& names);
/// Of the localizers of a record.
std::vector<std::size_t> localizer_styles(const ScanRecord& record);

}  // namespace castaway::testbed
