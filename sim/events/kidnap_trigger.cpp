#include "sim/events/kidnap_trigger.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/exponential_distribution.hpp>

namespace castaway::sim {

void validate(const KidnapTrigger& trigger) {
  const bool at_start = trigger.on == KidnapTrigger::On::kTime && trigger.times == 1;
  const bool possible = at_start ? trigger.value >= 0.0 : trigger.value > 0.0;
  if (!possible || !std::isfinite(trigger.value)) {
    throw std::invalid_argument(fmt::format("kidnap {}: the value is {}: give one above 0",
                                            describe(trigger), trigger.value));
  }
  if (trigger.times < 0) {
    throw std::invalid_argument(fmt::format("kidnap {}: times is {}: give 0 for no limit, or more",
                                            describe(trigger), trigger.times));
  }
}

std::string describe(const KidnapTrigger& trigger) {
  switch (trigger.on) {
    case KidnapTrigger::On::kTime:
      return fmt::format("at {} s", trigger.value);
    case KidnapTrigger::On::kDistance:
      return fmt::format("after {} m", trigger.value);
    case KidnapTrigger::On::kPoisson:
      return fmt::format("every {} s on average", trigger.value);
    default:
      return fmt::format("localized for {} s", trigger.value);
  }
}

KidnapClock::KidnapClock(const KidnapTrigger& trigger, Rng rng)
    : trigger_(trigger), rng_(rng), next_(trigger.value) {
  validate(trigger_);
  if (trigger_.on == KidnapTrigger::On::kPoisson) next_ = draw_gap();
}

double KidnapClock::draw_gap() {
  return boost::random::exponential_distribution<double>(1.0 / trigger_.value)(rng_);
}

bool KidnapClock::due(const TriggerInput& input) {
  if (!input.localized) {
    localized_since_.reset();
  } else if (!localized_since_) {
    localized_since_ = input.now_s;
  }
  if (trigger_.times > 0 && count_ >= trigger_.times) return false;
  switch (trigger_.on) {
    case KidnapTrigger::On::kDistance:
      return input.driven_m >= next_;
    case KidnapTrigger::On::kLocalized:
      return localized_since_ && input.now_s - *localized_since_ >= trigger_.value;
    default:
      return input.now_s >= next_;
  }
}

void KidnapClock::on_kidnap(const TriggerInput& input) {
  ++count_;
  localized_since_.reset();
  if (trigger_.on == KidnapTrigger::On::kPoisson) {
    next_ = input.now_s + draw_gap();
  } else {
    next_ += trigger_.value;
  }
}

}  // namespace castaway::sim
