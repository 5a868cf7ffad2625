/// The pictures of a run on its page.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// The pictures with captions, or why there are none. Of many, those of kidnaps and recoveries.
std::string pictures_section(const RunFolder& run);

}  // namespace castaway::testbed
