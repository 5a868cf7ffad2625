/// Recorded velocity commands: CSV with a header `t_s,v,w`.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/navigation/twist_log.hpp"

namespace castaway::testbed {

/// Reads lines of time [s], forward speed [m/s] and turn rate [rad/s], in order of times; empty
/// lines and lines from '#' on are skipped. Throws std::runtime_error naming file and line where
/// one cannot be read, goes back in time, or where there is none.
std::vector<sim::TimedTwist> read_twist_log(const std::filesystem::path& path);

}  // namespace castaway::testbed
