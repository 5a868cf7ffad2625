/// Pictures of a run in its report.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// The pictures with captions, or the reason why there are none. If there are too many, those of
/// kidnaps and recoveries are preferred.
std::string pictures_section(const RunFolder& run);

}  // namespace castaway::testbed
