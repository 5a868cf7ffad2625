#include "sim/events/kidnap.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "sim/world/free_space.hpp"

namespace castaway::sim {
namespace {

Pose2 checked_target(const KidnapSpec& spec, const FreeSpace& free) {
  if (!spec.target) {
    throw std::runtime_error(fmt::format(
        "kidnap at {} s: to a given pose, but none is given: add its target", spec.at_s));
  }
  const Pose2 target = *spec.target;
  if (!free.contains(target.position())) {
    throw std::runtime_error(fmt::format(
        "kidnap at {} s: target ({}, {}) is nearer than {:.2f} m to an obstacle, or cut off from "
        "the free space: choose another",
        spec.at_s, target.x, target.y, free.radius()));
  }
  return target;
}

Pose2 random_target(const KidnapSpec& spec, const Pose2& T_map_from, const FreeSpace& free,
                    Rng& rng) {
  const auto target = free.sample(rng, T_map_from.position(), spec.min_distance_m);
  if (!target) {
    throw std::runtime_error(
        fmt::format("kidnap at {} s: no free place {} m or more away from ({:.2f}, {:.2f}): lower "
                    "min_distance_m",
                    spec.at_s, spec.min_distance_m, T_map_from.x, T_map_from.y));
  }
  return *target;
}

}  // namespace

std::string to_string(KidnapKind kind) {
  return kind == KidnapKind::kTeleportTo ? "teleport_to" : "teleport";
}

Pose2 kidnap_target(const KidnapSpec& spec, const Pose2& T_map_from, const FreeSpace& free,
                    Rng& rng) {
  return spec.kind == KidnapKind::kTeleportTo ? checked_target(spec, free)
                                              : random_target(spec, T_map_from, free, rng);
}

}  // namespace castaway::sim
