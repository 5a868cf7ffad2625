/// The times of a bag's frames.
#pragma once

#include <optional>

#include "tools/ros/bag_topics.hpp"
#include "tools/sources/recorded_source.hpp"

namespace castaway::testbed {

/// Latest time that a bag may name. [ns] Sums of two times stay in range.
inline constexpr std::int64_t kLatestBagTime = std::int64_t{1} << 62;

/// Time 0 of the run that one of our own bags was recorded of; nothing of others.
std::optional<Stamp> time_0_of(const BagInventory& bag);

/// Sets the clock of frames, whose `Frame::stamp` is their log time, back to `time_0`, or to the
/// first stamp, and sorts them. Where log and stamps are of two clocks, the least difference is
/// taken off.
void set_times(const std::optional<Stamp>& time_0, Frames& frames);

}  // namespace castaway::testbed
