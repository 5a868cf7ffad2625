#include "sim/stages/progress_watch.hpp"

#include <cmath>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

constexpr double kAtOnce = 0.2;  // [s] A contact this soon after the start is one at the start.
// Share of the first `contact_s` that a contact at the start must last.
constexpr double kContactShare = 0.5;

bool differ(const Pose2& a, const Pose2& b, double way, double turn) {
  const Pose2 difference = inverse(a) * b;
  return difference.position().norm() >= way || std::abs(difference.yaw) >= turn;
}

}  // namespace

void ProgressWatch::update(const ProgressInput& input) {
  if (!first_) {
    first_ = input.now;
    last_ = input.now;
  }
  const double dt = to_seconds(input.now - last_);
  last_ = input.now;
  watch_contact(input, dt);
  if (input.wants) {
    wanted_s_ += dt;
    standing_s_ += dt;
  }
  if (!started_) started_ = input.T_map_base;
  moved_ = moved_ || differ(*started_, input.T_map_base, config_.first_way, config_.first_turn);
  const double way = input.passed == passed_ ? config_.way : config_.first_way;
  if (stood_ && !differ(*stood_, input.T_map_base, way, config_.turn)) return;
  leave();
  stood_ = input.T_map_base;
  since_ = input.now;
  passed_ = input.passed;
}

void ProgressWatch::watch_contact(const ProgressInput& input, double dt) {
  const double run = to_seconds(input.now - *first_);
  if (run > config_.contact_s || !input.touching) return;
  if (run <= kAtOnce) touched_at_once_ = true;
  contact_s_ += dt;
}

/// Ends the current standstill.
void ProgressWatch::leave() {
  if (standing_s_ >= config_.stuck_s) {
    stuck_s_ += standing_s_;
    if (!first_stuck_) first_stuck_ = since_;
  }
  standing_s_ = 0.0;
}

void ProgressWatch::on_teleport() {
  leave();
  stood_.reset();
  if (!moved_) started_.reset();
}

std::optional<VoidRecord> ProgressWatch::verdict() const {
  if (!first_) return std::nullopt;
  if (touched_at_once_ && contact_s_ >= kContactShare * config_.contact_s) {
    return VoidRecord{VoidReason::kContactFromStart, *first_};
  }
  if (!moved_ && wanted_s_ >= config_.never_s) return VoidRecord{VoidReason::kNeverMoved, *first_};
  const bool stuck = standing_s_ >= config_.stuck_s;
  const double stuck_s = stuck_s_ + (stuck ? standing_s_ : 0.0);
  if (!stuck && stuck_s < config_.stuck_share * wanted_s_) return std::nullopt;
  if (stuck_s == 0.0) return std::nullopt;
  return VoidRecord{VoidReason::kStuck, first_stuck_.value_or(since_)};
}

}  // namespace castaway::sim
