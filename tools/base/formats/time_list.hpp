/// Lists of times: one per line, in seconds since the start of a run.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Reads ascending times. Empty lines and lines that start with '#' are skipped. Throws
/// std::runtime_error naming file and line if a line is no time or goes back, or if there is none.
std::vector<std::chrono::nanoseconds> read_times(const std::filesystem::path& path);

/// The text of a list, with nanoseconds.
std::string times_text(const std::vector<std::chrono::nanoseconds>& times);

}  // namespace castaway::testbed
