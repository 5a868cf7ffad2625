/// Values of a campaign's keys in few words.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// A value on one line: "mh_amcl, amcl (preset amcl-recovery)". Maps are keys with their values,
/// lists their elements.
std::string value_words(const YamlNode& value);

/// The words of the values of a grid, found by their texts in rows.
class ValueLabels {
 public:
  ValueLabels() = default;
  explicit ValueLabels(const CampaignSpec& spec);

  /// `value`: as in `CellRow::values`. Itself if it is not of the grid.
  [[nodiscard]] std::string words(const std::string& key, const std::string& value) const;
  /// Of a localizer with the value `setting` of the key `localizers`: its own part of it.
  [[nodiscard]] std::string localizer(const std::string& name, const std::string& setting) const;

 private:
  std::map<std::pair<std::string, std::string>, YamlNode> values_;  // By key and text.
};

}  // namespace castaway::testbed
