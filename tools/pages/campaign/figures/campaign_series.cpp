#include "tools/pages/campaign/figures/campaign_series.hpp"

#include <algorithm>

#include "tools/outputs/pictures/localizer_styles.hpp"

namespace castaway::testbed {

const std::string* value_of(const CellRow& row, const std::string& key) {
  const auto found = std::find_if(row.values.begin(), row.values.end(),
                                  [&](const auto& pair) { return pair.first == key; });
  return found == row.values.end() ? nullptr : &found->second;
}

bool has_localizer(const CellRow& row, const std::string& localizer) {
  const std::string prefix = localizer + ".";
  const auto first = row.metrics.lower_bound(prefix);
  if (first != row.metrics.end() && first->first.starts_with(prefix)) return true;
  return std::any_of(row.kidnaps.begin(), row.kidnaps.end(),
                     [&](const CellKidnap& kidnap) { return kidnap.localizer == localizer; });
}

bool CampaignSeries::in(const CellRow& row) const {
  const std::string* value = value_of(row, kLocalizersKey);
  const bool set = setting.empty() || (value != nullptr && *value == setting);
  return set && has_localizer(row, localizer);
}

void SeriesFinder::add(const CellRow& row) {
  const std::string* value = value_of(row, kLocalizersKey);
  const std::string setting = value == nullptr ? "" : *value;
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    std::vector<std::string>& settings = settings_[i];
    const bool known = std::find(settings.begin(), settings.end(), setting) != settings.end();
    if (!known && has_localizer(row, localizers_[i])) settings.push_back(setting);
  }
}

std::vector<int> series_styles(const std::vector<CampaignSeries>& series) {
  std::vector<std::string> names;
  for (const CampaignSeries& each : series) names.push_back(each.localizer);
  const std::vector<std::size_t> styles = localizer_styles(names);
  std::vector<int> all(styles.begin(), styles.end());
  all.push_back(-1);
  return all;
}

std::vector<CampaignSeries> SeriesFinder::series() const {
  std::vector<CampaignSeries> all;
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    const std::string& name = localizers_[i];
    if (settings_[i].size() == 1) all.push_back({name, "", name});
    if (settings_[i].size() < 2) continue;
    for (const std::string& setting : settings_[i]) {
      all.push_back({name, setting, labels_.localizer(name, setting)});
    }
  }
  return all;
}

}  // namespace castaway::testbed
