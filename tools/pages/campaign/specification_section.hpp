/// What a campaign was made from, on its page.
#pragma once

#include <string>

#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// The keys that vary with their values, the other keys of the specification, and all of it as YAML
/// to be unfolded.
std::string specification_section(const CampaignSpec& spec);

}  // namespace castaway::testbed
