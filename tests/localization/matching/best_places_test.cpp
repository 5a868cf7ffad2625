#include "localization/matching/best_places.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

const GridFrame kFrame{20, 10, 0.2, {}};

BestPlaces nothing(int count) { return {kFrame, {4, 3}, count, 100}; }

TEST(BestPlaces, KeepsTheBestOfEveryBin) {
  BestPlaces best = nothing(10);
  best.offer({0, 0, 0, 5});
  best.offer({3, 3, 2, 7});  // same bin
  best.offer({4, 3, 2, 6});  // next bin in x
  best.offer({3, 3, 3, 4});  // next bin in yaw
  const std::vector<Place> expected{{3, 3, 2, 7}, {4, 3, 2, 6}, {3, 3, 3, 4}};
  EXPECT_EQ(best.list(), expected);
}

TEST(BestPlaces, BreaksTiesByPlace) {
  BestPlaces best = nothing(2);
  best.offer({8, 0, 0, 5});
  best.offer({1, 0, 0, 5});
  best.offer({0, 1, 0, 5});  // same bin, later row
  best.offer({4, 0, 0, 5});
  const std::vector<Place> expected{{1, 0, 0, 5}, {4, 0, 0, 5}};
  EXPECT_EQ(best.list(), expected);
}

TEST(BestPlaces, RaisesItsThresholdToTheLastOfTheList) {
  BestPlaces best = nothing(2);
  EXPECT_EQ(best.threshold(), 1);
  best.offer({0, 0, 0, 9});
  best.offer({1, 0, 0, 10});  // same bin
  EXPECT_EQ(best.threshold(), 1);
  best.offer({4, 0, 0, 4});
  EXPECT_EQ(best.threshold(), 4);
  best.offer({8, 0, 0, 6});
  EXPECT_EQ(best.threshold(), 6);
  best.offer({12, 0, 0, 100});
  EXPECT_EQ(best.threshold(), 10);
}

TEST(SparsePlaces, ListsThePlacesOfAllPagesInOrder) {
  SparsePlaces places;
  for (const int i : {1000, 0, 63, 64, 7}) places.at(static_cast<std::size_t>(i)) = {i, 0, 0, i};
  EXPECT_EQ(places.at(8), Place{});
  std::vector<int> listed;
  for (const Place& place : places.listed(7)) listed.push_back(place.score);
  EXPECT_EQ(listed, (std::vector<int>{7, 63, 64, 1000}));
}

TEST(BestPlaces, HoldsTilesThatDivideABin) {
  const BestPlaces best(kFrame, {8, 3}, 3, 100);
  EXPECT_TRUE(best.holds_tiles(8, 2));
  EXPECT_TRUE(best.holds_tiles(4, 2));
  EXPECT_FALSE(best.holds_tiles(16, 2));
  EXPECT_FALSE(best.holds_tiles(8, 3));
}

TEST(BestPlaces, ListsNoPlaceWithoutAScore) {
  BestPlaces best = nothing(3);
  best.offer({0, 0, 0, 0});
  EXPECT_TRUE(best.list().empty());
}

TEST(BestPlaces, ListsNoPlaceBelowTheLeastScore) {
  BestPlaces best(kFrame, {4, 3}, 3, 100, 7);
  EXPECT_EQ(best.threshold(), 7);
  best.offer({0, 0, 0, 6});
  best.offer({8, 0, 0, 7});
  EXPECT_EQ(best.list(), (std::vector<Place>{{8, 0, 0, 7}}));
}

TEST(BestPlaces, DoesNotDependOnTheOrderOfOffers) {
  Rng rng = substream(1, "best_places");
  std::vector<Place> places;
  for (int k = 0; k < 2000; ++k) {
    places.push_back({static_cast<int>(rng() % 20), static_cast<int>(rng() % 10),
                      static_cast<int>(rng() % 12), static_cast<int>(rng() % 30)});
  }
  BestPlaces forwards = nothing(25);
  for (const Place& place : places) forwards.offer(place);
  BestPlaces backwards = nothing(25);
  std::for_each(places.rbegin(), places.rend(), [&](const Place& p) { backwards.offer(p); });
  EXPECT_EQ(forwards.list().size(), 25U);
  EXPECT_EQ(forwards.list(), backwards.list());
  EXPECT_EQ(forwards.threshold(), forwards.list().back().score);
}

}  // namespace
}  // namespace castaway::localization
