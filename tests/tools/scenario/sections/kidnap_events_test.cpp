#include "tools/scenario/sections/kidnap_events.hpp"

#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using sim::KidnapKind;
using sim::KidnapTrigger;
using testing::HasSubstr;

EventSpecs events_of(const std::string& body) {
  YamlDocument document = YamlDocument::parse(body, "trial.yaml");
  YamlReader root = document.root();
  EventSpecs events;
  read_kidnap(root, events);
  document.reject_unknown_keys();
  return events;
}

sim::KidnapSpec kidnap(const std::string& body) { return events_of(body).simulated.kidnaps.at(0); }

std::string kidnap_error(const std::string& body) {
  try {
    events_of(body);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(KidnapEvents, HaveAKindForEveryWayOfKidnapping) {
  EXPECT_EQ(kidnap("{at_s: 3}").kind, KidnapKind::kTeleportRandom);
  EXPECT_EQ(kidnap("{at_s: 3, pose: [1, 2, 3]}").kind, KidnapKind::kTeleportTo);
  EXPECT_EQ(kidnap("{kind: look_alike, at_s: 3, min_distance_m: 5}").min_distance_m, 5.0);
  EXPECT_EQ(kidnap("{kind: nudge, at_s: 3, distance_m: [0.2, 0.4]}").nudge.max, 0.4);
  const auto turn = kidnap("{kind: turn, at_s: 3, angle_deg: [90, 180]}").turn;
  EXPECT_NEAR(turn.min, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(turn.max, std::numbers::pi, 1e-12);
  EXPECT_EQ(kidnap("{kind: spin, at_s: 3}").lift.height, 0.05);
  const auto carry = kidnap(
      "{kind: carry, at_s: 3, pose: [1, 2, 3], lift_m: 0.4, lift_s: 7, speed: 0.9, wheels: locked, "
      "covered: true, power_cycle: true}");
  EXPECT_EQ(carry.kind, KidnapKind::kCarry);
  EXPECT_EQ(*carry.target, (sim::Pose2{1.0, 2.0, 3.0}));
  EXPECT_EQ(carry.lift.height, 0.4);
  EXPECT_EQ(carry.lift.seconds, 7.0);
  EXPECT_EQ(carry.lift.speed, 0.9);
  EXPECT_EQ(carry.lift.wheels, sim::HeldWheels::kLocked);
  EXPECT_TRUE(carry.lift.covered);
  EXPECT_TRUE(carry.power_cycle);
}

TEST(KidnapEvents, ComeAtATimeAWayAtRandomOrWhenLocalized) {
  const auto when = [](const std::string& text) { return kidnap("{" + text + "}").when; };
  EXPECT_EQ(when("at_s: 3").on, KidnapTrigger::On::kTime);
  EXPECT_EQ(when("at_s: 3").times, 1);
  EXPECT_EQ(when("at_m: 20, times: 4").on, KidnapTrigger::On::kDistance);
  EXPECT_EQ(when("at_m: 20, times: 4").times, 4);
  EXPECT_EQ(when("poisson_s: 60").on, KidnapTrigger::On::kPoisson);
  EXPECT_EQ(when("poisson_s: 60").times, 0);
  EXPECT_EQ(when("when_localized_s: 5").on, KidnapTrigger::On::kLocalized);
  EXPECT_EQ(when("when_localized_s: 5").value, 5.0);
}

TEST(KidnapEvents, NameTheLocalizerThatTheyWaitFor) {
  EXPECT_EQ(events_of("{at_s: 3}").watched, "");
  EXPECT_EQ(events_of("{when_localized_s: 5, localizer: amcl}").watched, "amcl");
  EXPECT_TRUE(waits_for_localizer(events_of("{when_localized_s: 5}")));
  EXPECT_FALSE(waits_for_localizer(events_of("{poisson_s: 5}")));
}

TEST(KidnapEvents, SayWhatIsWrong) {
  EXPECT_THAT(kidnap_error("{kind: teleport}"), HasSubstr("'at_s', 'at_m', 'poisson_s'"));
  EXPECT_THAT(kidnap_error("{at_s: 3, at_m: 4}"), HasSubstr("give one of"));
  EXPECT_THAT(kidnap_error("{at_s: -3}"), HasSubstr("trial.yaml:1"));
  EXPECT_THAT(kidnap_error("{kind: teleprot, at_s: 3}"), HasSubstr("teleport"));
  EXPECT_THAT(kidnap_error("{at_s: 3, pose: [1, 2, 3], min_distance_m: 2}"), HasSubstr("not both"));
  EXPECT_THAT(kidnap_error("{at_s: 3, lift_m: 1}"), HasSubstr("lift_m"));
  EXPECT_THAT(kidnap_error("{kind: look_alike, at_s: 3, pose: [1, 2, 3]}"), HasSubstr("pose"));
  EXPECT_THAT(kidnap_error("{kind: nudge, at_s: 3, distance_m: [1, 0.5]}"), HasSubstr("in order"));
  EXPECT_THAT(kidnap_error("{kind: spin, at_s: 3, lift_m: 20}"), HasSubstr("0 to 3 m"));
  EXPECT_THAT(kidnap_error("{kind: carry, at_s: 3, wheels: square}"), HasSubstr("locked"));
  EXPECT_THAT(kidnap_error("{at_s: 3, localizer: amcl}"), HasSubstr("localizer"));
}

}  // namespace
}  // namespace castaway::testbed
