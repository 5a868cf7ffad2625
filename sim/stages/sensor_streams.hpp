/// The random streams of a run's sensors.
#pragma once

#include <string>

#include "sim/sensor/beam_light.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// Returns the stream `name`. @throws std::invalid_argument if the run has no named streams.
Rng named_stream(const SimulationStreams& streams, const std::string& name);

/// Returns the streams of a lidar. The noise of the lidar named "lidar" uses the run's lidar
/// stream; all others are "lidar/<name>/<effect>". @throws std::invalid_argument if an effect needs
/// a named stream and the run has none.
LidarDraws lidar_draws(const SimulationStreams& streams, const LidarConfig& lidar);

}  // namespace castaway::sim
