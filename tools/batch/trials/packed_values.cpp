#include "tools/batch/trials/packed_values.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json packed_bin(const CalibrationBin& bin) {
  return {bin.scans, bin.right, packed(bin.stated_sum)};
}

CalibrationBin unpacked_bin(const Json& json) {
  return {json.at(0).get<std::int64_t>(), json.at(1).get<std::int64_t>(),
          unpacked_double(json.at(2))};
}

}  // namespace

Json packed(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return value;
}

double unpacked_double(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  return json == "inf" ? infinity : -infinity;
}

Json packed(const std::optional<double>& value) { return value ? packed(*value) : Json(); }

std::optional<double> unpacked_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(unpacked_double(json));
}

Json packed(const Calibration& calibration) {
  Json bins = Json::array();
  for (const CalibrationBin& bin : calibration.bins) bins.push_back(packed_bin(bin));
  return {std::move(bins), packed(calibration.squares), packed_bin(calibration.sure)};
}

Calibration unpacked_calibration(const Json& json) {
  Calibration calibration;
  for (std::size_t i = 0; i < calibration.bins.size(); ++i) {
    calibration.bins[i] = unpacked_bin(json.at(0).at(i));
  }
  calibration.squares = unpacked_double(json.at(1));
  calibration.sure = unpacked_bin(json.at(2));
  return calibration;
}

}  // namespace castaway::testbed
