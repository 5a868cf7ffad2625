#include "tools/twin/log_fit.hpp"

#include <algorithm>
#include <cmath>

#include "tools/build/map_conversion.hpp"
#include "tools/twin/alignment/seen_building.hpp"
#include "tools/twin/fits/wall_fit.hpp"

namespace castaway::testbed {
namespace {

/// Improves the corrections of the scans by what fits the scans that were aligned with them.
void improve(const AlignedLog& log, double track, ScanCorrection& correction) {
  correction.T_reference_base = correction.T_reference_base * log.T_start_base;
  correction.drive = fit_drive_errors(take_legs(log, track), track);
  if (const auto clock = fit_clock(log, correction.drive.odometry)) {
    correction.stamp -= localization::from_seconds(clock->offset_s.value);
  }
  if (const auto noise = fit_range_noise(log)) {
    correction.walls = learn_walls(log, noise->bias_m.value);
  }
}

/// How far the ranges of a log lie behind the walls of its building. [m]
double bias_against(const RosMap& building, AlignedLog log) {
  log.grid = to_occupancy_grid(building);
  const auto noise = fit_range_noise(log);
  return noise ? noise->bias_m.value : 0.0;
}

Figure shift_figure(Figure figure, double by) {
  return {figure.value + by, {figure.interval.low + by, figure.interval.high + by}};
}

/// A standard deviation without a part of it.
Figure without(const Figure& sigma, double part) {
  const auto less = [part](double x) { return std::sqrt(std::max(x * x - part * part, 0.0)); };
  return {less(sigma.value), {less(std::max(sigma.interval.low, 0.0)), less(sigma.interval.high)}};
}

/// Takes the offsets of the beams, which are a model of their own, out of the noise.
void separate(const BeamBiasFit& bias, RangeNoiseFit& noise) {
  if (bias.sigma_m.interval.low <= 0.0) return;
  noise.sigma_m = without(noise.sigma_m, bias.sigma_m.value);
  noise.sigma_typical = without(noise.sigma_typical, bias.sigma_m.value);
}

}  // namespace

FittedLog fit_log(const RecordedPlace& place, const LogFitConfig& config) {
  constexpr int kImprovements = 3;
  ScanCorrection correction;
  AlignedLog log = align_log(place, config.align, correction);
  const bool around = looks_around(log);
  if (!around) sharpen_walls(log);
  for (int round = 0; round < kImprovements; ++round) {
    improve(log, config.track, correction);
    log = align_log(place, config.align, correction);
    if (around) continue;
    move_back(log);
    sharpen_walls(log);
  }
  LogFit fit;
  fit.odometry = fit_odometry(take_legs(log, config.track), config.track);
  fit.clock = fit_clock(log, fit.odometry ? fit.odometry->errors.odometry : OdometryErrors{});
  if (fit.clock) {
    fit.clock->offset_s = shift_figure(fit.clock->offset_s, -seconds(correction.stamp));
  }
  fit.stamps = fit_stamps(log.stamps);
  fit.noise = fit_range_noise(log);
  fit.loss = fit_loss(log);
  fit.mixed = fit_mixed(log);
  fit.dust = fit_dust(log);
  fit.beam_bias = fit_beam_bias(log);
  fit.range_limit = fit_range_limit(log);
  if (fit.noise && fit.beam_bias) separate(*fit.beam_bias, *fit.noise);
  fit.building = fit_building(log);
  RosMap building = see_building(place.map, log);
  fit.world_bias_m = bias_against(building, log);
  return {std::move(log), std::move(correction.walls), std::move(building), std::move(fit)};
}

}  // namespace castaway::testbed
