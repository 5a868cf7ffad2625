#include "sim/navigation/recoveries.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace castaway::sim {
namespace {

constexpr std::array<Recovery, 5> kOrder{Recovery::kWait, Recovery::kReplan, Recovery::kBackUp,
                                         Recovery::kSpin, Recovery::kReplan};
constexpr double kQuarter = 1.5708;  // [rad]
constexpr double kSideReach = 1.5;   // [m] Obstacles farther away do not decide the side of a spin.

/// 1 if there is more room to the left, -1 if to the right.
double roomier_side(const std::vector<Eigen::Vector2d>& p_base) {
  double balance = 0.0;
  for (const Eigen::Vector2d& p : p_base) {
    const double nearness = std::max(kSideReach - p.norm(), 0.0);
    balance -= nearness * p.normalized().y();
  }
  return balance >= 0.0 ? 1.0 : -1.0;
}

}  // namespace

std::optional<Recovery> Recoveries::watch(const Pose2& T_odom_base) {
  const Eigen::Vector2d p = T_odom_base.position();
  if (active_) return std::nullopt;
  if (!p_odom_progress_ || (p - *p_odom_progress_).norm() > times_.progress) {
    p_odom_progress_ = p;
    elapsed_ = 0.0;
  }
  if (p_odom_stuck_ && (p - *p_odom_stuck_).norm() > times_.forget) {
    p_odom_stuck_.reset();
    next_ = 0;
  }
  elapsed_ += period_;
  if (elapsed_ < times_.patience) return std::nullopt;
  if (!p_odom_stuck_) p_odom_stuck_ = p;
  active_ = kOrder[next_];
  next_ = (next_ + 1) % kOrder.size();
  fresh_ = true;
  return active_;
}

void Recoveries::begin(Recovery recovery, const Pose2& T_odom_base,
                       const std::vector<Eigen::Vector2d>& p_base) {
  fresh_ = false;
  elapsed_ = 0.0;
  T_odom_begin_ = T_odom_base;
  if (recovery == Recovery::kSpin) side_ = roomier_side(p_base);
}

std::optional<Twist2> Recoveries::wait() const {
  return elapsed_ < times_.wait ? std::optional(Twist2{}) : std::nullopt;
}

std::optional<Twist2> Recoveries::back_up(const Pose2& T_begin_base,
                                          const std::vector<Eigen::Vector2d>& p_base) const {
  const bool blocked = std::any_of(p_base.begin(), p_base.end(), [&](const Eigen::Vector2d& p) {
    return p.x() < 0.0 && p.norm() < radius_ + 0.05;
  });
  const bool over = T_begin_base.position().norm() >= times_.back_up ||
                    elapsed_ > 2.0 * times_.back_up / times_.back_up_speed;
  if (blocked || over) return std::nullopt;
  return Twist2{-times_.back_up_speed, 0.0};
}

std::optional<Twist2> Recoveries::spin(const Pose2& T_begin_base) const {
  const bool over =
      std::abs(T_begin_base.yaw) >= kQuarter || elapsed_ > 2.0 * kQuarter / times_.turn_rate;
  if (over) return std::nullopt;
  return Twist2{0.0, side_ * times_.turn_rate};
}

std::optional<Twist2> Recoveries::command(const Pose2& T_odom_base,
                                          const std::vector<Eigen::Vector2d>& p_base) {
  if (!active_) return std::nullopt;
  if (fresh_) begin(*active_, T_odom_base, p_base);
  elapsed_ += period_;
  const Pose2 T_begin_base = inverse(T_odom_begin_) * T_odom_base;
  std::optional<Twist2> twist;
  if (active_ == Recovery::kWait) twist = wait();
  if (active_ == Recovery::kBackUp) twist = back_up(T_begin_base, p_base);
  if (active_ == Recovery::kSpin) twist = spin(T_begin_base);
  if (twist) return twist;
  active_.reset();
  p_odom_progress_.reset();
  return std::nullopt;
}

}  // namespace castaway::sim
