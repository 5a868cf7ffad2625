#include "localization/paper/paper_config.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PaperMhAmclConfig, RefusesFiguresOutOfRange) {
  EXPECT_NO_THROW(validate(PaperMhAmclConfig{}));
  PaperMhAmclConfig config;
  config.size.min_particles = 1;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.match_period_s = 0.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.input.correct_rate_hz = 0.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
