/// Settings of AMCL as YAML, with Nav2's names.
#pragma once

#include <string>
#include <vector>

#include "localization/amcl/amcl_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// `amcl` (Nav2's defaults), `amcl-recovery` (recovery alphas as suggested in Nav2's
/// documentation), `amcl-global` (relocalizes globally at every kidnap, of which it is notified),
/// `amcl-prob` (product weights with beam skipping).
const std::vector<std::string>& amcl_presets();

/// Settings of a preset. That `amcl-global` is notified of kidnaps is part of its `LocalizerSpec`.
localization::AmclConfig amcl_preset(const std::string& preset);

void fields(Settings settings, localization::AmclConfig& config);

/// Reads the settings of a localizer; missing ones are those of the preset.
localization::AmclConfig read_amcl(YamlReader& body, const std::string& preset);

}  // namespace castaway::testbed
