#include "sim/people/people_config.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(PeopleConfig, CountsAllKinds) {
  PeopleConfig config;
  config.walking = 5;
  config.standing = 2;
  config.talking = {3, 2};
  config.placed = {{1.0, 2.0, 0.0}};
  EXPECT_EQ(config.count(), 13);
  EXPECT_EQ(PeopleConfig{}.count(), 0);
}

TEST(PeopleConfig, RefusesWhatCannotBe) {
  const auto refuses = [](auto change) {
    PeopleConfig config;
    change(config);
    EXPECT_THROW(validate(config), std::invalid_argument);
  };
  EXPECT_NO_THROW(validate(PeopleConfig{}));
  refuses([](PeopleConfig& c) { c.walking = -1; });
  refuses([](PeopleConfig& c) { c.standing = 201; });
  refuses([](PeopleConfig& c) { c.talking = {1}; });
  refuses([](PeopleConfig& c) { c.in_groups = 1.1; });
  refuses([](PeopleConfig& c) { c.blocked_share = 0.61; });
}

}  // namespace
}  // namespace castaway::sim
