/// Colours of position errors on paths.
#pragma once

#include <cstddef>
#include <string>

namespace castaway::testbed {

/// The step of a position error [m], 0 to 5: its colour is `--e0` to `--e5` of the style sheet. The
/// first three are right, the others wrong. `errorStep` of web/src/error_scale.js is the same.
std::size_t error_step(double error_m);

/// The colours with their errors.
std::string error_legend();

}  // namespace castaway::testbed
