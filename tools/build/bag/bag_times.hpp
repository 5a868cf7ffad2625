/// The times of a bag's frames.
#pragma once

#include <optional>

#include "tools/build/recorded/recorded_source.hpp"
#include "tools/ros/bag_topics.hpp"

namespace castaway::testbed {

/// [ns] Latest time that is accepted from a bag, so that the sum of two times does not overflow.
inline constexpr std::int64_t kLatestBagTime = std::int64_t{1} << 62;

/// Time 0 of the run that one of castaway's own bags records; nothing for other bags.
std::optional<Stamp> time_0_of(const BagInventory& bag);

/// Shifts the times of the frames, whose `Frame::stamp` is their log time, so that they start at
/// `time_0`, or at the first stamp, and sorts the frames. If log times and stamps are from
/// different clocks, the smallest difference is subtracted.
void set_times(const std::optional<Stamp>& time_0, Frames& frames);

}  // namespace castaway::testbed
