/// Availability of ffmpeg.
#pragma once

#include <cstdlib>

namespace castaway::testbed {

/// Whether the program ffmpeg is installed.
inline bool has_ffmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

}  // namespace castaway::testbed
