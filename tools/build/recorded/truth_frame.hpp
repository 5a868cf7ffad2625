/// Truth of a log that is recorded in another frame than its map's.
#pragma once

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// Turns true poses from the frame `truth` into the frame `map`.
void move_truth(Frames& frames, const SE2& T_map_truth);

}  // namespace castaway::testbed
