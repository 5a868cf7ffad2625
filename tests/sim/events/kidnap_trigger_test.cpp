#include "sim/events/kidnap_trigger.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using On = KidnapTrigger::On;

/// Times up to `end` at which a clock that is polled every 0.1 s triggers; the robot drives at 0.5
/// m/s.
std::vector<double> times_of(KidnapClock clock, double end) {
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(std::lround(end * 10.0)); ++i) {
    const TriggerInput input{0.1 * i, 0.05 * i, true};
    if (!clock.due(input)) continue;
    times.push_back(input.now_s);
    clock.on_kidnap(input);
  }
  return times;
}

TEST(KidnapClock, StrikesOnceAtItsTime) {
  EXPECT_EQ(times_of({{On::kTime, 3.0}, Rng()}, 20.0), (std::vector<double>{3.0}));
  EXPECT_EQ(times_of({{On::kTime, 0.0}, Rng()}, 20.0), (std::vector<double>{0.0}));
}

TEST(KidnapClock, StrikesAgainAfterAsMuchTimeOrWay) {
  const auto by_time = times_of({{On::kTime, 3.0, 2}, Rng()}, 20.0);
  ASSERT_EQ(by_time.size(), 2U);
  EXPECT_NEAR(by_time[1], 6.0, 1e-9);
  const auto by_way = times_of({{On::kDistance, 2.0, 0}, Rng()}, 20.0);
  ASSERT_EQ(by_way.size(), 5U);
  EXPECT_NEAR(by_way[4], 20.0, 1e-9);
}

TEST(KidnapClock, StaysDueUntilItHappens) {
  KidnapClock clock({On::kTime, 1.0}, Rng());
  EXPECT_FALSE(clock.due({0.9}));
  EXPECT_TRUE(clock.due({1.0}));
  EXPECT_TRUE(clock.due({1.1}));
  clock.on_kidnap({1.1});
  EXPECT_FALSE(clock.due({1.2}));
}

TEST(KidnapClock, PoissonGapsAreExponential) {
  const auto times = times_of({{On::kPoisson, 5.0, 0}, Rng(1)}, 50000.0);
  const auto count = static_cast<double>(times.size());
  EXPECT_NEAR(count, 10000.0, 4.0 * std::sqrt(10000.0) + 0.02 * count);  // polled every 0.1 s
  double longer = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i)
    longer += times[i] - times[i - 1] > 5.0 ? 1.0 : 0.0;
  const double share = std::exp(-1.0);
  EXPECT_NEAR(longer / count, share, 4.0 * std::sqrt(share * (1.0 - share) / count) + 0.01);
}

TEST(KidnapClock, WaitsUntilTheLocalizerIsSureForLongEnough) {
  KidnapClock clock({On::kLocalized, 2.0, 0}, Rng());
  EXPECT_FALSE(clock.due({0.0, 0.0, true}));
  EXPECT_FALSE(clock.due({1.9, 0.0, true}));
  EXPECT_FALSE(clock.due({1.95, 0.0, false}));
  EXPECT_FALSE(clock.due({2.0, 0.0, true}));
  EXPECT_FALSE(clock.due({3.9, 0.0, true}));
  EXPECT_TRUE(clock.due({4.0, 0.0, true}));
  clock.on_kidnap({4.0, 0.0, true});
  EXPECT_FALSE(clock.due({4.1, 0.0, true}));
  EXPECT_TRUE(clock.due({6.1, 0.0, true}));
}

TEST(KidnapTrigger, RefusesWhatNeverOrAlwaysComesTrue) {
  EXPECT_THROW(validate({On::kTime, -1.0}), std::invalid_argument);
  EXPECT_THROW(validate({On::kTime, 0.0, 3}), std::invalid_argument);
  EXPECT_THROW(validate({On::kDistance, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate({On::kLocalized, NAN}), std::invalid_argument);
  EXPECT_THROW(validate({On::kTime, 1.0, -1}), std::invalid_argument);
  EXPECT_NO_THROW(validate({On::kTime, 0.0}));
}

TEST(KidnapTrigger, SaysWhen) {
  EXPECT_EQ(describe({On::kTime, 30.0}), "at 30 s");
  EXPECT_EQ(describe({On::kDistance, 2.5}), "after 2.5 m");
  EXPECT_EQ(describe({On::kPoisson, 60.0}), "every 60 s on average");
  EXPECT_EQ(describe({On::kLocalized, 5.0}), "localized for 5 s");
}

}  // namespace
}  // namespace castaway::sim
