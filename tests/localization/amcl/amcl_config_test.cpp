#include "localization/amcl/amcl_config.hpp"

#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(AmclConfig, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(validate(AmclConfig{}));
  const std::vector<std::function<void(AmclConfig&)>> changes = {
      [](AmclConfig& c) { c.sensor.sigma_hit = 0.0; },
      [](AmclConfig& c) { c.sensor.max_distance = 0.0; },
      [](AmclConfig& c) { c.kld.error = 0.0; },
      [](AmclConfig& c) { c.max_range = 0.0; },
  };
  for (const auto& change : changes) {
    AmclConfig config;
    change(config);
    EXPECT_THROW(validate(config), std::invalid_argument);
  }
}

}  // namespace
}  // namespace castaway::localization
