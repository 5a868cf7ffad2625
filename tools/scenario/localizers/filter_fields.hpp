/// Settings shared by the MH-AMCLs, and their ranges.
#pragma once

#include "localization/mh_amcl/mh_amcl_config.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

inline constexpr NumberRange kShare{0.0, 1.0};
inline constexpr NumberRange kLength{0.0, 1e4};  // [m]
inline constexpr NumberRange kTime{0.0, 1e6};    // [s]
inline constexpr NumberRange kNats{-1e6, 1e6};
inline constexpr NumberRange kCount{1.0, 1e6};

/// Number of particles per population.
void size_fields(Settings& settings, localization::ReseedConfig& reseed);

void beam_fields(Settings& settings, localization::BeamSelection& beams);
void motion_fields(Settings& settings, localization::OdometryNoiseConfig& motion);

/// Rates, beams and motion.
template <typename Config>
void rate_fields(Settings& settings, Config& config) {
  settings.field({"predict_rate_hz", "Hz", "Rate of the prediction.", {0.01, 1e4}},
                 config.input.predict_rate_hz);
  settings.field({"correct_rate_hz", "Hz", "Rate of the correction.", {0.01, 1e4}},
                 config.input.correct_rate_hz);
  settings.field({"reseed_rate_hz", "Hz", "Rate of the reseeding.", {1e-3, 1e4}},
                 config.input.reseed_rate_hz);
  beam_fields(settings, config.input.beams);
  motion_fields(settings, config.motion);
}

}  // namespace castaway::testbed
