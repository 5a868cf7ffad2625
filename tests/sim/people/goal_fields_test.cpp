#include "sim/people/goal_fields.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/people/separation.hpp"
#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

/// A hall divided in two, with a door of 1 m at its northern end.
TestHall divided() {
  TestHall hall(8.0);
  hall.world.objects.push_back(box_on_floor("screen", {0.1, 7.0, 2.0}, {0.0, -0.5}));
  return hall;
}

TEST(GoalFields, LeadAroundWallsToEveryPlace) {
  const TestHall hall = divided();
  const WalkCells cells(WalkSpace(body_grid(hall.world, hall.map)));
  const WalkSpace& space = cells.space();
  Rng rng(1);
  GoalFields goals(cells, 12, rng);
  ASSERT_EQ(goals.places().size(), 12U);
  for (std::size_t place = 0; place < goals.places().size(); ++place) {
    Eigen::Vector2d p(-3.0, -3.0);
    double way = 0.0;
    for (int i = 0; i < 800 && (p - goals.places()[place]).norm() > 0.1; ++i) {
      const Eigen::Vector2d to = goals.ahead(place, p) - p;
      p = slide_along_walls(space, p, std::min(0.05, to.norm()) * to.normalized());
      way += 0.05;
    }
    EXPECT_LT((p - goals.places()[place]).norm(), 0.11);
    EXPECT_LT(way, 22.0);
  }
}

TEST(GoalFields, LookStraightAheadInTheOpen) {
  const TestHall hall(8.0);
  const WalkCells cells((WalkSpace(hall.map)));
  Rng rng(1);
  GoalFields goals(cells, 1, rng);
  const Eigen::Vector2d place = goals.places()[0];
  const Eigen::Vector2d from = place.x() > 0.0 ? Eigen::Vector2d(place.x() - 3.0, place.y())
                                               : Eigen::Vector2d(place.x() + 3.0, place.y());
  EXPECT_NEAR((goals.ahead(0, from) - from).norm(), 1.4, 0.2);
  EXPECT_NEAR((goals.ahead(0, place) - place).norm(), 0.0, 0.1);
}

TEST(GoalFields, RefuseAWorldWithoutRoom) {
  const WalkCells cells(WalkSpace(grid_from_art({"###", "#.#", "###"}, 0.05)));
  Rng rng(1);
  EXPECT_THROW(GoalFields(cells, 3, rng), std::runtime_error);
}

}  // namespace
}  // namespace castaway::sim
