/// Triggers of kidnaps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/common/random.hpp"

namespace castaway::sim {

/// A condition that becomes true once or repeatedly.
struct KidnapTrigger {
  enum class On : std::uint8_t {
    kTime,      ///< `value` [s] after the start, and every `value` from then on.
    kDistance,  ///< After `value` [m] driven, and every `value` from then on.
    kPoisson,   ///< At random times, exponentially distributed, `value` [s] apart on average.
    /// After the watched localizer has been right and not lost for `value` [s] without a break.
    kLocalized,
  };

  On on = On::kTime;
  double value = 30.0;  ///< [s] or [m], above 0; a time may be 0.
  int times = 1;        ///< Largest number of times; 0: no limit.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const KidnapTrigger& trigger);

/// "at 30 s", "after 20 m", "every 60 s on average", "localized for 5 s".
std::string describe(const KidnapTrigger& trigger);

/// State of a run that triggers depend on.
struct TriggerInput {
  double now_s = 0.0;      ///< [s] Since the start.
  double driven_m = 0.0;   ///< [m] Since the start, without kidnaps.
  bool localized = false;  ///< The watched localizer is right and does not report to be lost.
};

/// The state of a trigger during a run.
class KidnapClock {
 public:
  /// `rng` is used by kPoisson only.
  KidnapClock(const KidnapTrigger& trigger, Rng rng);

  /// True while a kidnap is due. Called at every step.
  bool due(const TriggerInput& input);
  /// Resets the trigger after its kidnap has happened.
  void on_kidnap(const TriggerInput& input);

 private:
  [[nodiscard]] double draw_gap();

  KidnapTrigger trigger_;
  Rng rng_;
  double next_ = 0.0;  ///< [s] or [m]
  std::optional<double> localized_since_;
  int count_ = 0;
};

}  // namespace castaway::sim
