#include "tools/pages/campaign/figures/value_labels.hpp"

#include <fmt/format.h>

#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/pages/campaign/figures/campaign_series.hpp"

namespace castaway::testbed {
namespace {

std::string joined(const std::string& before, const std::string& more) {
  return before.empty() ? more : before + ", " + more;
}

std::string entry_words(const YamlEntry& entry) {
  const std::string value = value_words(entry.value);
  if (value.empty()) return entry.key;
  const bool nested = entry.value.kind == YamlNode::Kind::kMap;
  return nested ? fmt::format("{} ({})", entry.key, value) : fmt::format("{} {}", entry.key, value);
}

/// The element of a list of localizers that is called `name`, or has its preset; null without one.
const YamlNode* element_called(const YamlNode& list, const std::string& name) {
  for (const YamlNode& item : list.items) {
    if (item.scalar == name) return &item;
    for (const YamlEntry& entry : item.entries) {
      const YamlNode* own = entry.value.find("name");
      const YamlNode* preset = entry.value.find("preset");
      if (own != nullptr ? own->scalar == name
                         : entry.key == name || (preset != nullptr && preset->scalar == name)) {
        return &item;
      }
    }
  }
  return nullptr;
}

}  // namespace

std::string value_words(const YamlNode& value) {
  std::string words;
  switch (value.kind) {
    case YamlNode::Kind::kScalar:
      return value.scalar;
    case YamlNode::Kind::kList:
      for (const YamlNode& item : value.items) words = joined(words, value_words(item));
      return words;
    case YamlNode::Kind::kMap:
      for (const YamlEntry& entry : value.entries) words = joined(words, entry_words(entry));
      return words;
    case YamlNode::Kind::kNull:
      return "";
  }
  return words;
}

ValueLabels::ValueLabels(const CampaignSpec& spec) {
  for (const GridKey& key : spec.grid) {
    for (const YamlNode& value : key.values) {
      values_.emplace(std::pair(key.path, value_text(value)), value);
    }
  }
}

std::string ValueLabels::words(const std::string& key, const std::string& value) const {
  const auto found = values_.find({key, value});
  if (found == values_.end()) return value;
  const std::string words = value_words(found->second);
  return words.empty() ? value : words;
}

std::string ValueLabels::localizer(const std::string& name, const std::string& setting) const {
  if (setting.empty()) return name;
  const auto found = values_.find({kLocalizersKey, setting});
  if (found == values_.end()) return fmt::format("{} ({})", name, setting);
  const YamlNode* element = element_called(found->second, name);
  const std::string words = value_words(element == nullptr ? found->second : *element);
  return words.starts_with(name) ? words : fmt::format("{} ({})", name, words);
}

}  // namespace castaway::testbed
