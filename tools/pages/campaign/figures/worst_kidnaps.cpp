#include "tools/pages/campaign/figures/worst_kidnaps.hpp"

#include <tuple>

namespace castaway::testbed {

bool WorstKidnap::operator<(const WorstKidnap& other) const {
  const auto rank = [](const WorstKidnap& each) {
    return std::tuple(-each.kidnap.lost_s, each.kidnap.kidnap.recovered,
                      -each.largest_error_m.value_or(0.0), each.cell, each.series,
                      each.kidnap.number);
  };
  return rank(*this) < rank(other);
}

void WorstKidnaps::add(WorstKidnap kidnap) {
  kidnaps_.insert(std::move(kidnap));
  if (kidnaps_.size() > most_) kidnaps_.erase(std::prev(kidnaps_.end()));
}

}  // namespace castaway::testbed
