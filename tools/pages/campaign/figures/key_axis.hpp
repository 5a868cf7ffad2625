/// Keys of a campaign as axes of plots.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/pages/campaign/figures/value_labels.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// A place on an axis: a value, or a range of drawn values.
struct AxisPlace {
  std::string label;
  double x = 0.0;  ///< The number; of a range, the median of its values; of texts, their order.
};

/// A varied key. Drawn numbers with more than eight values are divided into five ranges with
/// equally many seeds.
class KeyAxis {
 public:
  /// `values`: with repetitions; empty ones are left out. `labels`: their words.
  KeyAxis(std::string key, const std::vector<std::string>& values, bool drawn,
          const ValueLabels& labels = {});

  [[nodiscard]] const std::string& key() const { return key_; }
  [[nodiscard]] bool is_numeric() const { return numeric_; }
  [[nodiscard]] const std::vector<AxisPlace>& places() const { return places_; }
  /// Of the row's value; nothing if it has none.
  [[nodiscard]] std::optional<std::size_t> place_of(const CellRow& row) const;

 private:
  void add_values(const std::vector<std::string>& distinct, const ValueLabels& labels);
  void add_ranges(std::vector<double> ascending);

  std::string key_;
  bool numeric_ = false;
  std::vector<AxisPlace> places_;
  std::map<std::string, std::size_t> by_value_;
  std::vector<double> upper_;  // Ends of the ranges, each included.
};

/// All keys with more than one value other than `localizers`, which the series tell apart. Reads
/// the drawn values of the first `seeds` rows, as those of the others are the same.
std::vector<KeyAxis> key_axes(const CampaignSpec& spec, CellRows& rows);

}  // namespace castaway::testbed
