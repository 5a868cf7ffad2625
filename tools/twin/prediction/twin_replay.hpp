/// Plays a log in its twin: the same frames with simulated data.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// The part of a log that its twin plays: from the first aligned scan to the last, with the scans
/// of its first lidar. Where most scans have no reference pose, the aligned poses take their place.
RecordedPlace played_part(const RecordedPlace& place, const AlignedLog& log);

/// The same frames as measured in a twin: stamps and reference poses are those of the log, ranges
/// and odometry those of the twin. `played`: from `played_part`. `twin`: the frames of `run_twin`.
/// Throws std::runtime_error if the twin has other scans.
Frames replay_in_twin(const RecordedPlace& played, const AlignedLog& log, const Frames& twin);

}  // namespace castaway::testbed
