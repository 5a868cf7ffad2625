/// Settings of AMCL as YAML, by Nav2's names.
#pragma once

#include <string>
#include <vector>

#include "localization/amcl_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// `amcl` (Nav2's defaults), `amcl-recovery` (its documentation's recovery alphas), `amcl-global`
/// (told to localize globally at every kidnap), `amcl-prob` (product weights with beam skipping).
const std::vector<std::string>& amcl_presets();

/// The settings of a preset; that `amcl-global` is told stands in its `LocalizerSpec`.
localization::AmclConfig amcl_preset(const std::string& preset);

/// The settings of AMCL.
void fields(Settings settings, localization::AmclConfig& config);

/// Reads a localizer's body; what it does not say is as in the preset.
localization::AmclConfig read_amcl(YamlReader& body, const std::string& preset);

}  // namespace castaway::testbed
