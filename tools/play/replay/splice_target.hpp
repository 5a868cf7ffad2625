/// Chooses where in a log a kidnap leads.
#pragma once

#include <cstddef>
#include <functional>

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// Index of the scan whose true pose is nearest to a pose, a radian counting as much as half a
/// metre. `at_height`: says whether a scan at the true height z [m], 0 if it is unknown, counts.
/// Throws std::runtime_error if none is within 2 m of it, or if the log holds no true poses.
std::size_t nearest_scan(
    const Frames& frames, const SE2& T_map_base,
    const std::function<bool(double z)>& at_height = [](double) { return true; });

/// Index of the scan half a log from scan `from`, or of the next one that is at least
/// `min_distance_m` from it, where true poses are known. Throws std::runtime_error if there is
/// none.
std::size_t far_scan(const Frames& frames, std::size_t from, double min_distance_m);

/// Index of the scan most similar to scan `from` (`range_difference`) of those whose true pose is
/// at least `min_distance_m` from it. Throws std::runtime_error if there is none.
std::size_t look_alike_scan(const Frames& frames, std::size_t from, double min_distance_m);

}  // namespace castaway::testbed
