#include "sim/people/population.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

class PopulationTest : public ::testing::Test {
 protected:
  std::vector<Agent> draw(const PeopleConfig& config, std::uint64_t seed = 1) const {
    Rng rng(seed);
    const GoalFields goals(cells_, 16, rng);
    return draw_people(config, space_, goals, square_robot({0.0, 0.0, 0.0}), named_streams(seed));
  }

  TestHall hall_{20.0};
  WalkCells cells_{WalkSpace(hall_.map)};
  const WalkSpace& space_ = cells_.space();
};

TEST_F(PopulationTest, OneMorePersonShiftsNobody) {
  PeopleConfig config;
  config.walking = 10;
  config.standing = 3;
  config.behaviour.reset();
  config.in_groups = 0.5;
  const auto few = draw(config);
  config.walking = 14;
  const auto more = draw(config);
  ASSERT_EQ(more.size(), few.size() + 4);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].state.position, more[i].state.position);
    EXPECT_EQ(few[i].behaviour, more[i].behaviour);
    EXPECT_EQ(few[i].goal, more[i].goal);
    EXPECT_EQ(few[i].rng, more[i].rng);
  }
}

TEST_F(PopulationTest, NobodyStandsInAnybodyOrInTheRobot) {
  PeopleConfig config;
  config.walking = 150;
  config.in_groups = 0.5;
  config.talking = {2, 3, 4, 5, 6};
  const auto agents = draw(config);
  ASSERT_EQ(agents.size(), 170U);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const Eigen::Vector2d& p = agents[i].state.position;
    EXPECT_TRUE(space_.clear(p));
    EXPECT_GT(p.norm(), 0.29 + 0.2 + 0.59);
    for (std::size_t j = i + 1; j < agents.size(); ++j) {
      EXPECT_GE((p - agents[j].state.position).norm(), 0.4 - 1e-12);
    }
  }
}

TEST_F(PopulationTest, DesiredSpeedsAreNormalWithinTheirLimits) {
  PeopleConfig config;
  config.walking = 200;
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const Agent& agent : draw(config, seed)) {
      const double v = agent.body.desired_speed;
      EXPECT_GE(v, 0.5);
      EXPECT_LE(v, 2.0);
      sum += v;
      squares += v * v;
      ++count;
    }
  }
  const double mean = sum / count;
  EXPECT_NEAR(mean, 1.34, 4.0 * 0.26 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 0.26, 0.02);
}

TEST_F(PopulationTest, GroupsHoldTheWantedShareOfTheWalkers) {
  PeopleConfig config;
  config.walking = 200;
  config.in_groups = 0.6;
  int grouped = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto agents = draw(config, seed);
    for (std::size_t i = 0; i < agents.size(); ++i) {
      const bool leads = i + 1 < agents.size() && agents[i + 1].leader == i;
      grouped += agents[i].rank > 0 || leads ? 1 : 0;
      EXPECT_LT(agents[i].rank, 4);
      EXPECT_EQ(agents[i].goal, agents[agents[i].leader].goal);
      ++count;
    }
  }
  EXPECT_NEAR(grouped / static_cast<double>(count), 0.6, 0.08);
}

TEST_F(PopulationTest, WhoTalksFacesTheMiddle) {
  PeopleConfig config;
  config.talking = {3};
  const auto agents = draw(config);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Agent& agent : agents) middle += agent.state.position / 3.0;
  for (const Agent& agent : agents) {
    const Eigen::Vector2d to = (middle - agent.state.position).normalized();
    EXPECT_NEAR(to.dot(heading_vector(agent.state.heading)), 1.0, 1e-9);
  }
  EXPECT_NEAR((agents[0].state.position - agents[1].state.position).norm(), 0.7, 1e-9);
}

TEST_F(PopulationTest, PlacesPeopleWhereTheyAreAskedFor) {
  PeopleConfig config;
  config.placed = {{3.0, 4.0, 0.5}};
  EXPECT_EQ(draw(config)[0].state.position, Eigen::Vector2d(3.0, 4.0));
  config.placed = {{9.95, 0.0, 0.0}};
  EXPECT_THROW(draw(config), std::runtime_error);
}

TEST_F(PopulationTest, SaysWhereThereIsNoRoom) {
  const TestHall small(1.5);
  const WalkCells cells(WalkSpace(small.map));
  const WalkSpace& space = cells.space();
  Rng rng(1);
  const GoalFields goals(cells, 2, rng);
  PeopleConfig config;
  config.walking = 50;
  EXPECT_THROW(draw_people(config, space, goals, square_robot({9.0, 9.0, 0.0}), named_streams(1)),
               std::runtime_error);
}

}  // namespace
}  // namespace castaway::sim
