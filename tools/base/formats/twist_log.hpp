/// Reads recorded velocity commands: CSV with a header `t_s,v,w`.
#pragma once

#include <filesystem>
#include <vector>

namespace castaway::testbed {

/// A velocity command.
struct TwistLine {
  double t_s = 0.0;  ///< [s] Since the start of the run.
  double v = 0.0;    ///< [m/s] Forward.
  double w = 0.0;    ///< [rad/s] Counter-clockwise.
};

/// Reads lines of time [s], forward speed [m/s] and turn rate [rad/s], sorted by time. Empty lines
/// and lines that start with '#' are skipped. Throws std::runtime_error naming file and line if a
/// line is malformed or goes back in time, or if there is none.
std::vector<TwistLine> read_twist_log(const std::filesystem::path& path);

}  // namespace castaway::testbed
