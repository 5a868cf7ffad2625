#include "localization/search/work_budget.hpp"

#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr double kTilesPerMs = 8000.0;
constexpr double kTrackingMs = 0.4;      // Of the mean, for everything but the search.
constexpr double kFinishingShare = 0.6;  // Of the most, for weighing the places found.
constexpr double kSaved = 60.0;          // [s] Time whose earnings can be saved.
constexpr double kLeastShare = 0.1;      // Of the mean, always granted.

std::int64_t tiles_of(double ms) { return static_cast<std::int64_t>(ms * kTilesPerMs); }

}  // namespace

void validate(const WorkBudgetConfig& config) {
  if (!(config.mean_ms > 0.0)) throw std::invalid_argument("budget mean_ms must be positive");
  if (!(config.most_ms >= config.mean_ms)) {
    throw std::invalid_argument("budget most_ms must be at least mean_ms");
  }
}

WorkBudget::WorkBudget(const WorkBudgetConfig& config, double rate_hz)
    : rate_hz_(rate_hz),
      per_scan_(tiles_of(std::max(config.mean_ms - kTrackingMs, kLeastShare * config.mean_ms))),
      most_(tiles_of((1.0 - kFinishingShare) * config.most_ms)),
      capacity_(std::max(most_, static_cast<std::int64_t>(kSaved * rate_hz) * per_scan_)),
      least_(std::max<std::int64_t>(tiles_of(kLeastShare * config.mean_ms), 1)) {
  start();
}

void WorkBudget::start() {
  saved_ = capacity_;
  spent_ = 0;
  last_.reset();
}

void WorkBudget::earn(Stamp now) {
  const double due = last_ ? std::max(1.0, rate_hz_ * seconds(now - *last_)) : 1.0;
  last_ = now;
  spent_ = 0;
  const double earned =
      std::min(due * static_cast<double>(per_scan_), static_cast<double>(capacity_));
  saved_ = std::min(saved_ + static_cast<std::int64_t>(earned), capacity_);
}

}  // namespace castaway::localization
