/// Settings of the posterior over places and of the comparison of scans, and their ranges.
#pragma once

#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {

void fields(Settings settings, localization::ScanAgreementConfig& agreement);
void fields(Settings settings, localization::ScanContinuityConfig& continuity);
void fields(Settings settings, localization::PosteriorConfig& p);

}  // namespace castaway::testbed
