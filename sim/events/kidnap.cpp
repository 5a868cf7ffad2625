#include "sim/events/kidnap.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

[[noreturn]] void refuse(const KidnapSpec& spec, const std::string& what) {
  throw std::invalid_argument(fmt::format("kidnap {}: {}", describe(spec.when), what));
}

void check(const KidnapSpec& spec, const Bounds& bounds, const char* name, double limit) {
  if (bounds.min > 0.0 && bounds.min <= bounds.max && bounds.max <= limit) return;
  refuse(spec, fmt::format("{} from {} to {}: give bounds in order, above 0 and up to {:.4g}", name,
                           bounds.min, bounds.max, limit));
}

}  // namespace

void validate(const KidnapSpec& spec) {
  validate(spec.when);
  if (spec.kind == KidnapKind::kTeleportTo && !spec.target) {
    refuse(spec, "no target pose is given: add its target");
  }
  if (!(spec.min_distance_m >= 0.0)) {
    refuse(spec, fmt::format("min_distance_m is {}: give 0 or more", spec.min_distance_m));
  }
  if (spec.kind == KidnapKind::kNudge) check(spec, spec.nudge, "distance_m", 100.0);
  if (spec.kind == KidnapKind::kTurn) check(spec, spec.turn, "angle", std::numbers::pi + 1e-3);
  validate(spec.lift);
}

}  // namespace castaway::sim
