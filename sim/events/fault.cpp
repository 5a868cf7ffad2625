#include "sim/events/fault.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

nanoseconds end_of(const FaultSpec& fault) {
  return to_nanoseconds(fault.at_s) + to_nanoseconds(fault.for_s);
}

void require(bool condition, const FaultSpec& fault, const char* field, double value,
             const char* remedy) {
  if (condition && std::isfinite(value)) return;
  throw std::invalid_argument(
      fmt::format("fault {}: {} is {}: {}", to_string(fault.kind), field, value, remedy));
}

}  // namespace

void validate(const FaultSpec& fault) {
  require(fault.at_s >= 0.0 && fault.at_s < 1e9, fault, "at_s", fault.at_s, "give 0 or more");
  require(fault.for_s > 0.0 && fault.for_s < 1e9, fault, "for_s", fault.for_s,
          "give more than 0 seconds");
  require(std::abs(fault.from_deg) <= 360.0, fault, "from_deg", fault.from_deg,
          "give -360 to 360 degrees");
  require(std::abs(fault.to_deg) <= 360.0, fault, "to_deg", fault.to_deg,
          "give -360 to 360 degrees");
  require(fault.kind != FaultKind::kLidarBlocked || fault.from_deg != fault.to_deg, fault, "to_deg",
          fault.to_deg, "give another direction than from_deg; -180 to 180 covers all");
  require(fault.distance > 0.0, fault, "distance", fault.distance, "give more than 0 metres");
  require(fault.delay_s > 0.0 && fault.delay_s <= 10.0, fault, "delay_s", fault.delay_s,
          "give 0 to 10 seconds");
  require(std::abs(fault.offset_s) <= 10.0, fault, "offset_s", fault.offset_s,
          "give -10 to 10 seconds");
  require(fault.scale > 0.0 && fault.scale <= 10.0, fault, "scale", fault.scale,
          "give more than 0 and up to 10; 1 is exact");
}

bool is_active(const FaultSpec& fault, nanoseconds stamp) {
  if (fault.kind == FaultKind::kOdometryReset) return false;
  return stamp >= to_nanoseconds(fault.at_s) && stamp < end_of(fault);
}

FaultTimeline::FaultTimeline(const std::vector<FaultSpec>& faults) {
  for (const FaultSpec& fault : faults) add(fault);
}

void FaultTimeline::add(const FaultSpec& fault) {
  validate(fault);
  add({to_nanoseconds(fault.at_s), fault.kind, fault.lidar, true, {}});
  if (fault.kind == FaultKind::kOdometryReset) return;
  add({end_of(fault), fault.kind, fault.lidar, false, {}});
}

void FaultTimeline::add(const FaultRecord& record) {
  const auto later = [](const FaultRecord& a, const FaultRecord& b) { return a.stamp < b.stamp; };
  const auto begin = records_.begin() + static_cast<std::ptrdiff_t>(next_);
  records_.insert(std::upper_bound(begin, records_.end(), record, later), record);
}

std::vector<FaultRecord> FaultTimeline::take_due(nanoseconds now) {
  std::vector<FaultRecord> result;
  while (next_ < records_.size() && records_[next_].stamp <= now) {
    result.push_back(records_[next_++]);
  }
  return result;
}

}  // namespace castaway::sim
