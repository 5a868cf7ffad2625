/// A person's body, state and behaviour.
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// How people react to the robot; `reaction.hpp` defines each behaviour.
enum class Behaviour { kRegular, kImpassive, kSurprised, kCurious, kScared, kThreatening };

/// All behaviours, in this order.
inline constexpr std::array<Behaviour, 6> kBehaviours = {
    Behaviour::kRegular, Behaviour::kImpassive, Behaviour::kSurprised,
    Behaviour::kCurious, Behaviour::kScared,    Behaviour::kThreatening};

/// "regular", "impassive", ...: the name in scenarios.
constexpr const char* behaviour_name(Behaviour behaviour) {
  constexpr std::array<const char*, kBehaviours.size()> names = {
      "regular", "impassive", "surprised", "curious", "scared", "threatening"};
  return names[static_cast<std::size_t>(behaviour)];
}

/// Constants of a body. Heights are above the floor.
struct PersonBody {
  double radius = 0.2;          ///< [m] Disc that keeps free of the robot and of others.
  double height = 1.75;         ///< [m]
  double leg_radius = 0.07;     ///< [m] Below `kTorsoBottom` a lidar sees legs.
  double desired_speed = 1.34;  ///< [m/s]
};

inline constexpr double kTorsoBottom = 0.5;       ///< [m] Legs below, torso above.
inline constexpr double kTorsoHalfWidth = 0.225;  ///< [m] Across.
inline constexpr double kTorsoHalfDepth = 0.14;   ///< [m] Front to back.
inline constexpr double kHeadRadius = 0.1;        ///< [m]
inline constexpr double kHeadHeight = 0.28;       ///< [m] Head and neck.
inline constexpr double kFootSpread = 0.1;        ///< [m] Of each foot from the middle.

/// Where a person is. Frame map.
struct PersonState {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double heading = 0.0;                                ///< [rad] Where body and face point.
  double gait_phase = 0.0;  ///< In [0, 1): left foot planted below 0.5, right foot above.
  std::array<Eigen::Vector2d, 2> feet = {Eigen::Vector2d::Zero(),
                                         Eigen::Vector2d::Zero()};  ///< [m] Left, right.
};

/// The state a fraction of the way from `a` to `b`.
PersonState between(const PersonState& a, const PersonState& b, double fraction);

/// Unit vector of a heading [rad].
Eigen::Vector2d heading_vector(double heading);

}  // namespace castaway::sim
