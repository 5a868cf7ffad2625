/// Effects on a lidar's light between the device and the surface it hits.
#pragma once

namespace castaway::sim {

/// All off by default: every surface within range returns every beam.
struct LightEffects {
  /// [m] Range at which a surface of reflectivity 0.1 is just detected at a right angle;
  /// proportional to the square root of reflectivity times cosine of incidence. 0: everything
  /// within range is detected.
  double dark_range = 0.0;
  double dropout = 0.0;      ///< Share of returns that are lost, [0, 1].
  double dropout_far = 0.0;  ///< Additional share at range_max; grows with the square of the range.
  double dropout_grazing = 0.0;  ///< Additional share at grazing incidence; grows with 1 - cosine.
  double dropout_dark = 0.0;  ///< Additional share on black surfaces; grows with 1 - reflectivity.
  double dust_rate = 0.0;     ///< [1/m] Grains or drops per metre of beam that return it.
  double dust_range = 5.0;    ///< [m] Farther grains return too little light.
  /// [deg] Full opening angle of the beam; 0: a line, no mixed pixels.
  double divergence_deg = 0.0;
  /// [m] Depth steps within a beam up to this size are reported as one range in between; larger
  /// ones give separate echoes.
  double mixed_reach = 0.5;
  bool glass = false;  ///< Light passes glass; false: glass returns light like a wall.
  /// Share of beams that a pane reflects, [0, 1], within `glass_angle_deg`.
  double glass_return = 0.9;
  double glass_angle_deg = 3.0;  ///< [deg] Largest angle to the normal at which a pane reflects.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const LightEffects& effects);

/// True if any effect is on.
bool any(const LightEffects& effects);

/// Meaning of a beam's intensity.
enum class Intensity {
  kNone,          ///< No intensities.
  kPower,         ///< Received power: reflectivity * cosine of incidence / range^2, range in m.
  kReflectivity,  ///< Corrected for range: reflectivity * cosine of incidence, [0, 1].
};

/// Share of returns that are lost. `range_per_max`: range divided by range_max.
double lost_share(const LightEffects& effects, double range_per_max, double cosine,
                  double reflectivity);

/// Range up to which a surface is detected, infinite without `dark_range`. [m]
double seen_within(const LightEffects& effects, double cosine, double reflectivity);

}  // namespace castaway::sim
