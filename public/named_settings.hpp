/// Settings of a localizer by name, for the options of castaway/mh_amcl.hpp and castaway/amcl.hpp.
#pragma once

#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway {

/// Texts of settings by key.
using NamedSettings = std::map<std::string, std::string>;

/// Collects options that differ from their defaults, by the keys of their settings.
class NamedOptions {
 public:
  template <typename T>
  NamedOptions& add(const char* key, const T& value, const T& usual) {
    if (value != usual) settings_[key] = fmt::format("{}", value);
    return *this;
  }
  /// All of them, with the further settings, which override them.
  [[nodiscard]] NamedSettings with(const NamedSettings& further) const {
    NamedSettings all = further;
    all.insert(settings_.begin(), settings_.end());
    return all;
  }

 private:
  NamedSettings settings_;
};

/// The settings as a document, whose errors name `who`, key and value. @throws std::runtime_error
/// for a value that is no YAML, std::invalid_argument for a key that is none.
testbed::YamlDocument settings_document(const std::string& who, const NamedSettings& settings);

}  // namespace castaway
