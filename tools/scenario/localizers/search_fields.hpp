/// Settings of the search for further places, and their ranges.
#pragma once

#include "tools/scenario/localizers/filter_fields.hpp"

namespace castaway::testbed {

void fields(Settings settings, localization::MatcherConfig& matcher);
void fields(Settings settings, localization::MatchScheduleConfig& match);
void fields(Settings settings, localization::PlaceWatchConfig& watch);
void fields(Settings settings, localization::RescueConfig& rescue);
void fields(Settings settings, localization::CreateConfig& create);

}  // namespace castaway::testbed
