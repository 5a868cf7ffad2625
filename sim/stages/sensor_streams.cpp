#include "sim/stages/sensor_streams.hpp"

#include <stdexcept>

namespace castaway::sim {

Rng named_stream(const SimulationStreams& streams, const std::string& name) {
  if (streams.named) return streams.named(name);
  throw std::invalid_argument("sensors: no random stream '" + name +
                              "': give SimulationStreams::named");
}

LidarDraws lidar_draws(const SimulationStreams& streams, const LidarConfig& lidar) {
  const std::string prefix = "lidar/" + lidar.name + "/";
  LidarDraws draws;
  const bool first = lidar.name == LidarConfig{}.name;
  draws.noise = first ? streams.lidar : named_stream(streams, prefix + "noise");
  const bool pattern = lidar.noise.beam_bias_sigma > 0.0;
  if (pattern) draws.pattern = named_stream(streams, prefix + "pattern");
  if (lidar.stamp_sigma > 0.0) draws.stamps = named_stream(streams, prefix + "stamps");
  if (!any(lidar.light)) return draws;
  draws.edges = named_stream(streams, prefix + "edges");
  draws.glass = named_stream(streams, prefix + "glass");
  draws.dust = named_stream(streams, prefix + "dust");
  draws.dropout = named_stream(streams, prefix + "dropout");
  return draws;
}

}  // namespace castaway::sim
