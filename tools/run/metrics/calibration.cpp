#include "tools/run/metrics/calibration.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

std::optional<double> share(double part, std::int64_t whole) {
  if (whole == 0) return std::nullopt;
  return part / static_cast<double>(whole);
}

}  // namespace

void CalibrationBin::add(double probability, bool is_right) {
  ++scans;
  if (is_right) ++right;
  stated_sum += probability;
}

void CalibrationBin::add(const CalibrationBin& other) {
  scans += other.scans;
  right += other.right;
  stated_sum += other.stated_sum;
}

std::optional<double> CalibrationBin::stated() const { return share(stated_sum, scans); }

std::optional<double> CalibrationBin::observed() const {
  return share(static_cast<double>(right), scans);
}

RateInterval CalibrationBin::interval() const {
  return wilson_interval(static_cast<int>(right), static_cast<int>(scans));
}

void Calibration::add(double probability, bool right) {
  const double stated = std::clamp(probability, 0.0, 1.0);
  const double outcome = right ? 1.0 : 0.0;
  const auto count = static_cast<double>(bins.size());
  bins[std::min(static_cast<std::size_t>(stated * count), bins.size() - 1)].add(stated, right);
  if (stated >= kSure) sure.add(stated, right);
  squares += (stated - outcome) * (stated - outcome);
}

void Calibration::add(const Calibration& other) {
  for (std::size_t i = 0; i < bins.size(); ++i) bins[i].add(other.bins[i]);
  sure.add(other.sure);
  squares += other.squares;
}

std::int64_t Calibration::scans() const {
  std::int64_t sum = 0;
  for (const CalibrationBin& bin : bins) sum += bin.scans;
  return sum;
}

std::optional<double> Calibration::brier() const { return share(squares, scans()); }

Calibration calibration_of(const std::vector<MetricRow>& rows, const RecoveryConfig& config) {
  Calibration calibration;
  for (const MetricRow& row : rows) {
    if (std::isnan(row.probability)) continue;
    if (pose_error(row)) calibration.add(row.probability, is_right(row, config));
  }
  return calibration;
}

}  // namespace castaway::testbed
