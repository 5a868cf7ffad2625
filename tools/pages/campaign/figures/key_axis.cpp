#include "tools/pages/campaign/figures/key_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/pages/campaign/figures/campaign_series.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMostValues = 8;  // Of a drawn key that is not divided into ranges.
constexpr std::size_t kRanges = 5;

std::vector<std::string> distinct_values(const std::vector<std::string>& values) {
  std::vector<std::string> distinct;
  std::set<std::string> seen;
  for (const std::string& value : values) {
    if (!value.empty() && seen.insert(value).second) distinct.push_back(value);
  }
  return distinct;
}

/// The values as numbers; nothing if one of them is none.
std::optional<std::vector<double>> numbers_of(const std::vector<std::string>& values) {
  std::vector<double> numbers;
  for (const std::string& value : values) {
    if (value.empty()) continue;
    const auto number = number_of(value);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Values of key number `key` of the grid.
std::vector<std::string> grid_values(const CampaignSpec& spec, std::size_t key) {
  std::vector<std::string> values;
  for (int k = 0; k < spec.combinations(); ++k) {
    values.push_back(combination_values(spec, k)[key].second);
  }
  return values;
}

std::vector<std::string> drawn_values(const CampaignSpec& spec, CellRows& rows,
                                      const std::string& key) {
  std::vector<std::string> values;
  for (int s = 0; s < spec.samples(); ++s) {
    int cell = s;  // All combinations have the same values.
    while (cell < spec.cells() && !rows.has(cell)) cell += spec.samples();
    if (cell >= spec.cells()) continue;
    const CellRow row = rows.row(cell);
    if (const std::string* value = value_of(row, key)) values.push_back(*value);
  }
  return values;
}

}  // namespace

KeyAxis::KeyAxis(std::string key, const std::vector<std::string>& values, bool drawn,
                 const ValueLabels& labels)
    : key_(std::move(key)) {
  std::vector<std::string> distinct = distinct_values(values);
  auto numbers = numbers_of(values);
  numeric_ = numbers && !numbers->empty();
  if (!numeric_) {
    add_values(distinct, labels);
    return;
  }
  if (drawn && distinct.size() > kMostValues) {
    std::sort(numbers->begin(), numbers->end());
    add_ranges(std::move(*numbers));
    return;
  }
  std::stable_sort(distinct.begin(), distinct.end(),
                   [](const auto& a, const auto& b) { return *number_of(a) < *number_of(b); });
  add_values(distinct, labels);
}

void KeyAxis::add_values(const std::vector<std::string>& distinct, const ValueLabels& labels) {
  for (const std::string& value : distinct) {
    by_value_[value] = places_.size();
    const auto order = static_cast<double>(places_.size());
    places_.push_back({labels.words(key_, value), numeric_ ? *number_of(value) : order});
  }
}

void KeyAxis::add_ranges(std::vector<double> ascending) {
  for (std::size_t i = 0; i < kRanges; ++i) {
    const auto end =
        ascending.begin() + static_cast<std::ptrdiff_t>(ascending.size() * (i + 1) / kRanges);
    const auto begin = upper_.empty()
                           ? ascending.begin()
                           : std::upper_bound(ascending.begin(), ascending.end(), upper_.back());
    if (begin >= end) continue;  // Equal values are in one range.
    upper_.push_back(*(end - 1));
    const auto last = std::upper_bound(begin, ascending.end(), upper_.back());
    places_.push_back(
        {fmt::format("{:.4g} to {:.4g}", *begin, upper_.back()), percentile({begin, last}, 0.5)});
  }
}

std::optional<std::size_t> KeyAxis::place_of(const CellRow& row) const {
  const std::string* value = value_of(row, key_);
  if (value == nullptr) return std::nullopt;
  if (upper_.empty()) {
    const auto found = by_value_.find(*value);
    return found == by_value_.end() ? std::nullopt : std::optional(found->second);
  }
  const auto number = number_of(*value);
  if (!number) return std::nullopt;
  const auto at = std::lower_bound(upper_.begin(), upper_.end(), *number);
  return at == upper_.end() ? std::nullopt
                            : std::optional(static_cast<std::size_t>(at - upper_.begin()));
}

std::vector<KeyAxis> key_axes(const CampaignSpec& spec, CellRows& rows) {
  std::vector<KeyAxis> axes;
  const auto add = [&](KeyAxis axis) {
    if (axis.places().size() > 1) axes.push_back(std::move(axis));
  };
  const ValueLabels labels(spec);
  for (std::size_t i = 0; i < spec.grid.size(); ++i) {
    const std::string& key = spec.grid[i].path;
    if (key != kLocalizersKey) add(KeyAxis(key, grid_values(spec, i), false, labels));
  }
  for (const DrawnKey& key : spec.drawn) {
    add(KeyAxis(key.path, drawn_values(spec, rows, key.path), true));
  }
  return axes;
}

}  // namespace castaway::testbed
