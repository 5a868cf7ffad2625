/// People, their streams and a robot for tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/people/people.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {

/// Streams that differ by seed and name.
inline NamedStreams named_streams(std::uint64_t seed) {
  return [seed](const std::string& name) {
    std::uint64_t hash = 14695981039346656037ULL + seed;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return Rng(hash);
  };
}

/// A square robot of 0.4 m edge at rest.
inline RobotBody square_robot(const Pose2& T_map_base) {
  return {{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}}, 0.29, T_map_base, {0.0, 0.0}};
}

/// A hall of `edge` x `edge` m centred at the origin with walls of 0.1 m, and its map.
struct TestHall {
  explicit TestHall(double edge) {
    const double half = 0.5 * edge;
    world.name = "hall";
    world.min_corner = {-half - 0.1, -half - 0.1};
    world.max_corner = {half + 0.1, half + 0.1};
    world.objects = {box_on_floor("south", {edge + 0.2, 0.1, 2.0}, {0.0, -half - 0.05}),
                     box_on_floor("north", {edge + 0.2, 0.1, 2.0}, {0.0, half + 0.05}),
                     box_on_floor("west", {0.1, edge, 2.0}, {-half - 0.05, 0.0}),
                     box_on_floor("east", {0.1, edge, 2.0}, {half + 0.05, 0.0})};
    map = empty_map();
  }
  [[nodiscard]] Grid empty_map() const;

  WorldSpec world;
  Grid map;
};

/// Where people can walk in a world.
inline std::shared_ptr<const WalkCells> walk_cells(const WorldSpec& world, const Grid& map) {
  return std::make_shared<const WalkCells>(WalkSpace(body_grid(world, map)));
}

/// An agent with the default body at a place.
inline Agent agent_at(const Eigen::Vector2d& p_map, double heading = 0.0) {
  Agent agent;
  agent.state.position = agent.anchor = agent.waypoint = p_map;
  agent.state.heading = agent.anchor_heading = heading;
  return agent;
}

}  // namespace castaway::sim
