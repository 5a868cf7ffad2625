#include "sim/events/kidnap.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string kidnap_error(const KidnapSpec& spec) {
  try {
    validate(spec);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Kidnap, RunsByItsDefaults) {
  for (const KidnapKind kind : {KidnapKind::kTeleportRandom, KidnapKind::kLookAlike,
                                KidnapKind::kNudge, KidnapKind::kTurn, KidnapKind::kCarry}) {
    EXPECT_EQ(kidnap_error({.kind = kind}), "");
  }
}

TEST(Kidnap, SaysWhatIsWrongWithIt) {
  EXPECT_THAT(kidnap_error({.kind = KidnapKind::kTeleportTo}),
              AllOf(HasSubstr("at 30 s"), HasSubstr("add its target")));
  EXPECT_THAT(kidnap_error({.min_distance_m = -1.0}), HasSubstr("min_distance_m is -1"));
  EXPECT_THAT(kidnap_error({.kind = KidnapKind::kNudge, .nudge = {1.0, 0.5}}),
              AllOf(HasSubstr("distance_m"), HasSubstr("in order")));
  EXPECT_THAT(kidnap_error({.kind = KidnapKind::kTurn, .turn = {0.0, 1.0}}), HasSubstr("angle"));
  EXPECT_THAT(kidnap_error({.kind = KidnapKind::kTurn, .turn = {1.0, 4.0}}), HasSubstr("3.1"));
  EXPECT_THAT(kidnap_error({.when = {KidnapTrigger::On::kPoisson, 0.0}}), HasSubstr("above 0"));
  EXPECT_THAT(kidnap_error({.kind = KidnapKind::kCarry, .lift = {.height = 9.0}}),
              HasSubstr("lift_m is 9"));
}

}  // namespace
}  // namespace castaway::sim
