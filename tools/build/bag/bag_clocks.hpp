/// What the stamps of another robot's bag say about its clocks.
#pragma once

#include <string>
#include <vector>

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// Removes scans and odometry that are stamped earlier than one before of their lidar, or of
/// odometry: a clock that steps back tells some time twice. `Frame::stamp` is the log time. Returns
/// a warning for each kind that had any.
std::vector<std::string> remove_repeated_times(const std::string& bag, Frames& frames);

/// Warns of lidars whose clock differs from that of odometry by 0.15 s or more. The difference is
/// estimated from how long after its stamp a message is logged, the median of each; a scan is taken
/// as logged when its last beam is measured. `Frame::stamp` is the log time.
std::vector<std::string> warn_of_clocks(const std::string& bag, const Frames& frames);

/// Subtracts `offset` [s] from the stamps of all scans.
void shift_scans(double offset, Frames& frames);

/// Delivers each scan that is stamped more than 0.15 s later than the newest odometry once odometry
/// has caught up; the last ones never. Frames are in order of `Frame::stamp`, and stay so.
void await_odometry(Frames& frames);

}  // namespace castaway::testbed
