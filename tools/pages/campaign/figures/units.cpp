#include "tools/pages/campaign/figures/units.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

using Ending = std::pair<std::string_view, const char*>;

/// Endings of a part of a name; the longer one of two that fit comes first.
constexpr std::array<Ending, 14> kEndings{{{"_m_s", "m/s"},
                                           {"_rad_s", "rad/s"},
                                           {"_per_h", "1/h"},
                                           {"_per_m", "1/m"},
                                           {"_ms", "ms"},
                                           {"_mb", "MB"},
                                           {"_hz", "Hz"},
                                           {"_deg", "°"},
                                           {"_rad", "rad"},
                                           {"_share", "0 to 1"},
                                           {"_auc", "0 to 1"},
                                           {"_m", "m"},
                                           {"_s", "s"},
                                           {"_kg", "kg"}}};
constexpr std::array<std::string_view, 6> kShares{"success",       "availability", "brier",
                                                  "share_of_time", "truth_share",  "share"};

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts{""};
  for (const char c : path) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// The path without the numbers that stand for elements of lists.
std::string without_numbers(const std::string& path) {
  std::string text;
  for (const std::string& part : parts_of(path)) {
    const bool number = !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
    if (!number) text += (text.empty() ? "" : ".") + part;
  }
  return text;
}

}  // namespace

std::string metric_unit(const std::string& metric) {
  const std::vector<std::string> parts = parts_of(metric);
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    if (std::find(kShares.begin(), kShares.end(), *part) != kShares.end()) return "0 to 1";
    for (const auto& [ending, unit] : kEndings) {
      if (part->ends_with(ending)) return unit;
    }
  }
  return "";
}

std::string key_unit(const std::string& key) {
  const std::string wanted = without_numbers(key);
  for (const SettingText& setting : scenario_settings()) {
    if (without_numbers(setting.path) == wanted && !setting.unit.empty()) return setting.unit;
  }
  return metric_unit(key);
}

}  // namespace castaway::testbed
