/// Text of a trial's report, for transfer between processes.
#pragma once

#include <string>

#include "tools/batch/trials/kidnap_summary.hpp"

namespace castaway::testbed {

/// All values exactly.
std::string pack_report(const KidnapReport& report);
/// Throws std::runtime_error for any other text.
KidnapReport unpack_report(const std::string& text);

}  // namespace castaway::testbed
