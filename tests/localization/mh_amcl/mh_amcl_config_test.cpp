#include "localization/mh_amcl/mh_amcl_config.hpp"

#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(MhAmclConfig, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(validate(MhAmclConfig{}));
  const std::vector<std::function<void(MhAmclConfig&)>> changes = {
      [](MhAmclConfig& c) { c.input.predict_rate_hz = 0.0; },
      [](MhAmclConfig& c) { c.max_distance = 0.0; },
      [](MhAmclConfig& c) { c.match.confident = 0.0; },
      [](MhAmclConfig& c) { c.match.slice = 0; },
      [](MhAmclConfig& c) { c.lost_and_found.found = 1.1; },
      [](MhAmclConfig& c) { c.history = 0; },
      [](MhAmclConfig& c) { c.reseed.min_particles = 0; },
      [](MhAmclConfig& c) { c.mixture.most = 0; },
      [](MhAmclConfig& c) { c.ndt.cell = 0.0; },
  };
  for (const auto& change : changes) {
    MhAmclConfig config;
    change(config);
    EXPECT_THROW(validate(config), std::invalid_argument);
  }
}

TEST(MhAmclConfig, HasAMixtureWherePopulationsAreNormalDistributions) {
  MhAmclConfig config;
  EXPECT_FALSE(mixture_of(config));
  config.belief = BeliefKind::kGaussians;
  config.mixture.most = 3;
  EXPECT_EQ(mixture_of(config).value().most, 3);
}

}  // namespace
}  // namespace castaway::localization
