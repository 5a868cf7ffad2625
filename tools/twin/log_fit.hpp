/// Everything that a log and its map tell about the robot, its sensors and its building.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "tools/twin/fits/beam_bias_fit.hpp"
#include "tools/twin/fits/building_fit.hpp"
#include "tools/twin/fits/clock_fit.hpp"
#include "tools/twin/fits/dust_fit.hpp"
#include "tools/twin/fits/loss_fit.hpp"
#include "tools/twin/fits/mixed_fit.hpp"
#include "tools/twin/fits/range_limit_fit.hpp"
#include "tools/twin/fits/range_noise_fit.hpp"
#include "tools/twin/fits/stamp_fit.hpp"
#include "tools/twin/odometry/odometry_fit.hpp"

namespace castaway::testbed {

/// Fitted models; those that the log cannot tell are missing.
struct LogFit {
  StampFit stamps;
  std::optional<ClockFit> clock;
  std::optional<OdometryFit> odometry;
  std::optional<RangeNoiseFit> noise;
  std::optional<LossFit> loss;
  std::optional<MixedFit> mixed;
  std::optional<DustFit> dust;
  std::optional<BeamBiasFit> beam_bias;
  std::optional<RangeLimitFit> range_limit;
  std::optional<BuildingFit> building;
  double world_bias_m = 0.0;  ///< [m] Ranges behind the walls of the building.
};

/// Parameters of a fit.
struct LogFitConfig {
  AlignBy align = AlignBy::kAuto;
  double track = 0.3;  ///< [m] Between the wheels of the robot that odometry's errors are stated
                       ///< for.
};

/// An aligned log and what was fitted to it.
struct FittedLog {
  AlignedLog log;                    ///< With the stamps of the scans on odometry's clock.
  std::optional<WallOffsets> walls;  ///< Surfaces of the walls that it was aligned with.
  RosMap building;                   ///< As the log saw it.
  LogFit fit;
};

/// Aligns a log and fits all models. Throws as `align_log`.
FittedLog fit_log(const RecordedPlace& place, const LogFitConfig& config);

nlohmann::ordered_json to_json(const Figure& figure);
nlohmann::ordered_json to_json(const FittedLog& fitted);

}  // namespace castaway::testbed
