#include "tools/trials/packed_values.hpp"

#include <utility>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json packed_bin(const CalibrationBin& bin) { return {bin.scans, bin.right, bin.stated_sum}; }

CalibrationBin unpacked_bin(const Json& json) {
  return {json.at(0).get<std::int64_t>(), json.at(1).get<std::int64_t>(), json.at(2).get<double>()};
}

}  // namespace

Json packed(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::optional<double> unpacked_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Json packed(const Calibration& calibration) {
  Json bins = Json::array();
  for (const CalibrationBin& bin : calibration.bins) bins.push_back(packed_bin(bin));
  return {std::move(bins), calibration.squares, packed_bin(calibration.sure)};
}

Calibration unpacked_calibration(const Json& json) {
  Calibration calibration;
  for (std::size_t i = 0; i < calibration.bins.size(); ++i) {
    calibration.bins[i] = unpacked_bin(json.at(0).at(i));
  }
  calibration.squares = json.at(1).get<double>();
  calibration.sure = unpacked_bin(json.at(2));
  return calibration;
}

}  // namespace castaway::testbed
