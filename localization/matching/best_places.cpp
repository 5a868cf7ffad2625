#include "localization/matching/best_places.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace castaway::localization {
namespace {

bool better(const Place& a, const Place& b) {
  if (a.score != b.score) return a.score > b.score;
  return std::tie(a.yaw, a.row, a.column) < std::tie(b.yaw, b.row, b.column);
}

}  // namespace

std::vector<Place> SparsePlaces::listed(int least) const {
  std::vector<Place> places;
  for (const std::unique_ptr<Page>& page : pages_) {
    if (!page) continue;
    std::copy_if(page->begin(), page->end(), std::back_inserter(places),
                 [least](const Place& place) { return place.score >= least; });
  }
  return places;
}

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
  Place& best = bins_.at(static_cast<std::size_t>(bin));
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
  std::vector<Place> places = bins_.listed(threshold_);
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.score > b.score; });
  places.resize(std::min(places.size(), static_cast<std::size_t>(count_)));
  return places;
}

}  // namespace castaway::localization
