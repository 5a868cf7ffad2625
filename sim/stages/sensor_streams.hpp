/// The random streams of a run's sensors.
#pragma once

#include <string>

#include "sim/sensor/beam_light.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// Returns the stream `name`. @throws std::invalid_argument if the run has no named streams.
Rng named_stream(const SimulationStreams& streams, const std::string& name);

/// The streams of a lidar: the noise of the one named "lidar" is the run's lidar stream, all others
/// are "lidar/<name>/<effect>". Without streams by name, effects that need them are an error.
LidarDraws lidar_draws(const SimulationStreams& streams, const LidarConfig& lidar);

}  // namespace castaway::sim
