#include "sim/events/kidnap.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/world/free_space.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

FreeSpace hall() { return {make_grid(200, 100, 0.05, {0.0, 0.0}, Cell::kFree), 0.3}; }

std::string error_of(const KidnapSpec& spec) {
  Rng rng(1);
  try {
    kidnap_target(spec, {5.0, 2.5, 0.0}, hall(), rng);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Kidnap, GoesFarEnoughIntoFreeSpace) {
  KidnapSpec spec;
  spec.min_distance_m = 4.0;
  const FreeSpace free = hall();
  Rng rng(3);
  for (int i = 0; i < 500; ++i) {
    const Pose2 to = kidnap_target(spec, {2.0, 2.0, 0.0}, free, rng);
    ASSERT_GE((to.position() - Eigen::Vector2d(2.0, 2.0)).norm(), 4.0);
    ASSERT_TRUE(free.contains(to.position()));
  }
}

TEST(Kidnap, GoesWhereItIsTold) {
  KidnapSpec spec;
  spec.kind = KidnapKind::kTeleportTo;
  spec.target = Pose2{1.0, 2.0, 3.0};
  Rng rng(1);
  EXPECT_EQ(kidnap_target(spec, {}, hall(), rng), *spec.target);
}

TEST(Kidnap, SaysWhyItIsImpossible) {
  KidnapSpec spec;
  spec.min_distance_m = 50.0;
  EXPECT_THAT(error_of(spec), AllOf(HasSubstr("30 s"), HasSubstr("50 m"), HasSubstr("lower")));
  spec.kind = KidnapKind::kTeleportTo;
  EXPECT_THAT(error_of(spec), HasSubstr("add its target"));
  spec.target = Pose2{0.1, 2.0, 0.0};
  EXPECT_THAT(error_of(spec), AllOf(HasSubstr("(0.1, 2)"), HasSubstr("obstacle")));
}

TEST(Kidnap, HasAName) {
  EXPECT_EQ(to_string(KidnapKind::kTeleportRandom), "teleport");
  EXPECT_EQ(to_string(KidnapKind::kTeleportTo), "teleport_to");
}

}  // namespace
}  // namespace castaway::sim
