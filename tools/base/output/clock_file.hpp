/// The files of a run that hold clock readings, so that their bytes differ in every repetition.
#pragma once

#include <filesystem>
#include <string>

namespace castaway::testbed {

/// True for the names that may have no hash in a list. They lie at the top of their folder.
bool holds_clock_readings(const std::string& path);

/// True if a file begins as the one of this name does that castaway writes. It stands in for the
/// hash, so that a list cannot claim a file of the user's that has such a name.
bool is_clock_file(const std::filesystem::path& file);

}  // namespace castaway::testbed
