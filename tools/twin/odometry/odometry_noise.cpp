#include "tools/twin/odometry/odometry_noise.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace castaway::testbed {
namespace {

constexpr int kParts = 6;
using Parts = Eigen::Matrix<double, kParts, 1>;

Parts parts_of(const OdometryNoise& n) {
  return (Parts() << n.along_per_m, n.match, n.yaw_per_m, n.yaw_per_rad, n.match_yaw, n.stamp)
      .finished();
}

OdometryNoise noise_of(const Parts& p) {
  return {.along_per_m = p(0),
          .yaw_per_m = p(2),
          .yaw_per_rad = p(3),
          .match = p(1),
          .match_yaw = p(4),
          .stamp = p(5)};
}

/// How much of each part is in the variance along, across and in yaw.
Eigen::Matrix<double, 3, kParts> shares_of(const Stretch& s) {
  Eigen::Matrix<double, 3, kParts> shares;
  shares.row(0) << s.walk.x(), 2.0, s.sway.x(), s.swing.x(), s.lever.x(), s.speeds.x();
  shares.row(1) << s.walk.y(), 2.0, s.sway.y(), s.swing.y(), s.lever.y(), s.speeds.y();
  shares.row(2) << 0.0, 0.0, s.way, s.turn, 2.0, s.turn_rates;
  return shares;
}

/// A squared miss and the shares of its variance.
struct Square {
  double value = 0.0;
  Parts shares;
  bool is_yaw = false;

  /// True if it says more about errors of the yaw, which squares of yaws tell better.
  [[nodiscard]] bool is_sideways(const Parts& at) const {
    const double by_yaw = shares(2) * at(2) + shares(3) * at(3) + shares(4) * at(4);
    return !is_yaw && 2.0 * by_yaw > shares.dot(at);
  }
};

std::vector<Square> take_squares(const std::vector<const std::vector<Stretch>*>& sets,
                                 const DriveErrors& errors) {
  std::vector<Square> squares;
  for (const auto* stretches : sets) {
    for (const Stretch& s : *stretches) {
      const SE2 miss = miss_of(s, errors);
      const Eigen::Vector3d misses(miss.x, miss.y, miss.yaw);
      const auto shares = shares_of(s);
      for (int row = 0; row < 3; ++row) {
        squares.push_back({misses(row) * misses(row), shares.row(row).transpose(), row == 2});
      }
    }
  }
  return squares;
}

/// A part that is left out is zero.
Parts leave_out(Parts parts, YawWalk walk) {
  if (walk == YawWalk::kTurn) parts(2) = 0.0;
  if (walk == YawWalk::kTravel) parts(3) = 0.0;
  return parts;
}

/// Far outliers all count the same.
double log_likelihood(const std::vector<Square>& squares, const Parts& at) {
  constexpr double kFar = 5.0;  // Standard deviations.
  double sum = 0.0;
  for (const Square& s : squares) {
    const double variance = s.shares.dot(at);
    sum -= 0.5 * (std::log(variance) + std::min(s.value / variance, kFar * kFar));
  }
  return sum;
}

/// The x without negative entries that minimises x' A x / 2 - b' x, by coordinate descent.
Parts solve_not_negative(const Eigen::Matrix<double, kParts, kParts>& A, const Parts& b, Parts x) {
  constexpr int kSweeps = 300;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const Parts before = x;
    for (int k = 0; k < kParts; ++k) {
      if (A(k, k) > 0.0) x(k) = std::max(x(k) + (b(k) - A.row(k).dot(x)) / A(k, k), 0.0);
    }
    if (((x - before).array().abs() <= 1e-9 * x.array()).all()) break;
  }
  return x;
}

}  // namespace

Eigen::Vector3d OdometryNoise::variances(const Stretch& stretch) const {
  return shares_of(stretch) * parts_of(*this);
}

OdometryNoise fit_noise(const std::vector<const std::vector<Stretch>*>& sets,
                        const DriveErrors& errors, const OdometryNoise& start, YawWalk walk) {
  constexpr double kTrim = 2.5;       // Standard deviations.
  constexpr double kUntrim = 1.0974;  // Makes up for the tails of normal misses beyond.
  constexpr int kWide = 6;            // Rounds without the trim: the first variances may be small.
  constexpr double kLeast = 1e-12;
  const std::vector<Square> squares = take_squares(sets, errors);
  Parts at = leave_out(parts_of(start), walk);
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix<double, kParts, kParts> A = Eigen::Matrix<double, kParts, kParts>::Zero();
    Parts b = Parts::Zero();
    const double untrim = round >= kWide ? kUntrim : 1.0;
    for (const Square& s : squares) {
      const double variance = s.shares.dot(at);
      const bool is_trimmed = round >= kWide && s.value > kTrim * kTrim * variance;
      if (is_trimmed || s.is_sideways(at)) continue;
      const Parts shares = leave_out(s.shares, walk);
      A += shares * shares.transpose() / (variance * variance);
      b += shares * (untrim * s.value) / (variance * variance);
    }
    at = leave_out(solve_not_negative(A, b, at).cwiseMax(kLeast), walk);
  }
  return noise_of(at);
}

YawWalk choose_walk(const std::vector<const std::vector<Stretch>*>& sets, const DriveErrors& errors,
                    const OdometryNoise& start) {
  const std::vector<Square> squares = take_squares(sets, errors);
  const auto count = static_cast<double>(squares.size());
  YawWalk chosen = YawWalk::kTravelAndTurn;
  double best = log_likelihood(squares, parts_of(start)) - 0.5 * std::log(count);
  for (const YawWalk walk : {YawWalk::kTravel, YawWalk::kTurn}) {
    const OdometryNoise noise = fit_noise(sets, errors, start, walk);
    const double value = log_likelihood(squares, parts_of(noise));
    if (value < best) continue;
    best = value;
    chosen = walk;
  }
  return chosen;
}

}  // namespace castaway::testbed
