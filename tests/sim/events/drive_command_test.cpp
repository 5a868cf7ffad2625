#include "sim/events/drive_command.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(DriveCommand, TakesAVelocityOrNone) {
  EXPECT_NO_THROW(validate(DriveCommand{0.0, Twist2{0.2, -1.0}}));
  EXPECT_NO_THROW(validate(DriveCommand{5.0, std::nullopt}));
}

TEST(DriveCommand, RefusesATimeBeforeTheStart) {
  EXPECT_THROW(validate(DriveCommand{-0.1, std::nullopt}), std::invalid_argument);
  EXPECT_THROW(validate(DriveCommand{std::numeric_limits<double>::quiet_NaN(), std::nullopt}),
               std::invalid_argument);
}

TEST(DriveCommand, RefusesVelocitiesThatAreNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(validate(DriveCommand{0.0, Twist2{infinity, 0.0}}), std::invalid_argument);
  EXPECT_THROW(validate(DriveCommand{0.0, Twist2{0.0, -infinity}}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
