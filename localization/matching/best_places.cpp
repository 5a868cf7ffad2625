#include "localization/matching/best_places.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace castaway::localization {
namespace {

bool better(const Place& a, const Place& b) {
  if (a.score != b.score) return a.score > b.score;
  return std::tie(a.yaw, a.row, a.column) < std::tie(b.yaw, b.row, b.column);
}

}  // namespace

BestPlaces::BestPlaces(const GridFrame& frame, const BinSize& size, int count, int max_score,
                       int least)
    : size_(size),
      columns_(frame.width / size.cells + 1),
      rows_(frame.height / size.cells + 1),
      count_(count),
      bins_of_score_(static_cast<std::size_t>(max_score) + 1),
      threshold_(std::clamp(least, 1, max_score)) {}

void BestPlaces::offer(const Place& place) {
  if (place.score < threshold_) return;
  const int bin = ((place.yaw / size_.yaws) * rows_ + place.row / size_.cells) * columns_ +
                  place.column / size_.cells;
  Place& best = bins_[bin];
  if (!better(place, best)) return;
  raise_threshold(best.score, place.score);
  best = place;
}

/// Keeps the threshold at the highest score that `count` bins reach.
void BestPlaces::raise_threshold(int before, int now) {
  --bins_of_score_[static_cast<std::size_t>(before)];
  ++bins_of_score_[static_cast<std::size_t>(now)];
  if (before <= threshold_ && now > threshold_) ++bins_above_;
  while (bins_above_ >= count_) {
    bins_above_ -= bins_of_score_[static_cast<std::size_t>(++threshold_)];
  }
}

std::vector<Place> BestPlaces::list() const {
  std::vector<std::pair<int, Place>> listed;
  std::copy_if(bins_.begin(), bins_.end(), std::back_inserter(listed),
               [&](const auto& entry) { return entry.second.score >= threshold_; });
  std::stable_sort(listed.begin(), listed.end(),
                   [](const auto& a, const auto& b) { return a.second.score > b.second.score; });
  listed.resize(std::min(listed.size(), static_cast<std::size_t>(count_)));
  std::vector<Place> places;
  for (const auto& entry : listed) places.push_back(entry.second);
  return places;
}

}  // namespace castaway::localization
