/// What becomes of a lidar's light between the device and the thing it meets.
#pragma once

namespace castaway::sim {

/// All off by default: every surface within range returns every beam.
struct LightEffects {
  double dark_range = 0.0;   ///< [m] At which a surface of reflectivity 0.1 is just seen, met at a
                             ///< right angle; goes with the root of reflectivity times cosine of
                             ///< incidence. 0: everything within range is seen.
  double dropout = 0.0;      ///< Share of the returns that are lost, [0, 1]...
  double dropout_far = 0.0;  ///< ...besides at range_max, with the square of range...
  double dropout_grazing = 0.0;  ///< ...besides at grazing incidence, with 1 - cosine...
  double dropout_dark = 0.0;     ///< ...besides on black, with 1 - reflectivity.
  double dust_rate = 0.0;        ///< [1/m] Grains or drops in a metre of beam that return it.
  double dust_range = 5.0;       ///< [m] Farther ones return too little light.
  double divergence_deg = 0.0;   ///< [deg] Full opening of the beam; 0: a line, no mixed pixels.
  double mixed_reach = 0.5;      ///< [m] Depth steps within a beam that are reported as one range
                                 ///< somewhere between; the echoes of larger ones are told apart.
  bool glass = false;            ///< Light passes glass; false: it returns light as a wall does.
  double glass_return = 0.9;     ///< Share of beams that a pane mirrors back, [0, 1]...
  double glass_angle_deg = 3.0;  ///< [deg] ...within this angle off its normal; beyond it, none.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const LightEffects& effects);

/// True if any effect is on.
bool any(const LightEffects& effects);

/// What a beam's intensity tells.
enum class Intensity {
  kNone,          ///< There are none.
  kPower,         ///< Received power: reflectivity * cosine of incidence / range^2, range in m.
  kReflectivity,  ///< Freed of range: reflectivity * cosine of incidence, [0, 1].
};

/// Share of returns lost at a range [m], cosine of incidence and reflectivity.
double lost_share(const LightEffects& effects, double range_per_max, double cosine,
                  double reflectivity);

/// Where a surface is just seen. [m]; infinite without `dark_range`.
double seen_within(const LightEffects& effects, double cosine, double reflectivity);

}  // namespace castaway::sim
