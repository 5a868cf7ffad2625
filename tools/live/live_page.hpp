/// The page of a live run.
#pragma once

#include <string>

namespace castaway::testbed {

/// HTML of the page, whole: it loads nothing else. Throws std::runtime_error if the program was
/// built without Node.js.
std::string live_page(const std::string& scenario);

}  // namespace castaway::testbed
