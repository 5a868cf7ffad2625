#include "localization/paper/paper_config.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PaperMhAmclConfig, RefusesFiguresOutOfRange) {
  EXPECT_NO_THROW(validate(PaperMhAmclConfig{}));
  for (double PaperMhAmclConfig::*figure :
       {&PaperMhAmclConfig::predict_rate_hz, &PaperMhAmclConfig::correct_rate_hz,
        &PaperMhAmclConfig::reseed_rate_hz, &PaperMhAmclConfig::match_period_s}) {
    PaperMhAmclConfig config;
    config.*figure = 0.0;
    EXPECT_THROW(validate(config), std::invalid_argument);
  }
  PaperMhAmclConfig config;
  config.size.min_particles = 1;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.beams.max_beams = 0;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
