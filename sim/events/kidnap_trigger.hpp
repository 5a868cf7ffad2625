/// When a kidnap happens.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/common/random.hpp"

namespace castaway::sim {

/// A condition that comes true once or again and again.
struct KidnapTrigger {
  enum class On : std::uint8_t {
    kTime,       ///< `value` [s] after the start, and every `value` from then on.
    kDistance,   ///< After `value` [m] driven, and every `value` from then on.
    kPoisson,    ///< At random, `value` [s] apart on average: an exponential law.
    kLocalized,  ///< Once the watched localizer has been right and sure for `value` [s] on end.
  };

  On on = On::kTime;
  double value = 30.0;  ///< [s] or [m] Above 0; a time may be 0.
  int times = 1;        ///< How often at most; 0: as often as it comes true.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const KidnapTrigger& trigger);

/// "at 30 s", "after 20 m", "every 60 s on average", "localized for 5 s".
std::string describe(const KidnapTrigger& trigger);

/// What triggers go by.
struct TriggerInput {
  double now_s = 0.0;      ///< [s] Since the start.
  double driven_m = 0.0;   ///< [m] Since the start, kidnaps aside.
  bool localized = false;  ///< The watched localizer is right and sure.
};

/// A trigger on its way through a run.
class KidnapClock {
 public:
  /// `rng` is drawn from by kPoisson only.
  KidnapClock(const KidnapTrigger& trigger, Rng rng);

  /// True while a kidnap is due. To be asked at every step.
  bool due(const TriggerInput& input);
  /// The kidnap has happened: the trigger is off until it comes true again.
  void happened(const TriggerInput& input);

 private:
  [[nodiscard]] double drawn_gap();

  KidnapTrigger trigger_;
  Rng rng_;
  double next_ = 0.0;  ///< [s] or [m]
  std::optional<double> localized_since_;
  int count_ = 0;
};

}  // namespace castaway::sim
