#include "localization/search/work_budget.hpp"

#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr double kTrackingMs = 0.4;    // Of the mean, for everything but the search.
constexpr double kSearchShare = 0.35;  // Of the most, for the searches,
constexpr double kPlacesShare = 0.65;  // and for these and the weighing of the places found.
constexpr double kSaved = 60.0;        // [s] Time whose earnings can be saved.
constexpr double kLeastShare = 0.1;    // Of the mean, always granted.

std::int64_t tiles_of(double ms, double rate) { return static_cast<std::int64_t>(ms * rate); }

}  // namespace

void validate(const WorkBudgetConfig& config) {
  if (!(config.mean_ms > 0.0)) throw std::invalid_argument("budget mean_ms must be positive");
  if (!(config.most_ms >= config.mean_ms)) {
    throw std::invalid_argument("budget most_ms must be at least mean_ms");
  }
}

double tiles_per_ms(std::size_t cells) {
  constexpr double kSmall = 8000.0;
  constexpr double kHalf = 2e6;  // Cells of a map that takes twice the time.
  return kSmall / (1.0 + static_cast<double>(cells) / kHalf);
}

WorkBudget::WorkBudget(const WorkBudgetConfig& config, double rate_hz, std::size_t cells)
    : rate_hz_(rate_hz) {
  const double rate = tiles_per_ms(cells);
  const double least_ms = kLeastShare * config.mean_ms;
  per_scan_ = tiles_of(std::max(config.mean_ms - kTrackingMs, least_ms), rate);
  most_ = tiles_of(kPlacesShare * config.most_ms, rate);
  most_of_search_ = tiles_of(kSearchShare * config.most_ms, rate);
  capacity_ = std::max(most_of_search_, static_cast<std::int64_t>(kSaved * rate_hz) * per_scan_);
  least_ = std::max<std::int64_t>(tiles_of(least_ms, rate), 1);
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
