/// The simplest localizer: the start pose propagated by odometry. It shows the minimal interface.
#pragma once

#include "castaway/localizer.hpp"

namespace castaway::test {

class DeadReckoning final : public localization::Localizer {
 public:
  void initialize(const std::optional<localization::PoseWithCovariance>& start) override {
    start_ = start;
    T_odom_start_.reset();
    estimate_.reset();
  }
  void on_odometry(const localization::Odometry& odometry) override {
    if (!T_odom_start_) T_odom_start_ = odometry.T_odom_base;
    T_odom_base_ = odometry.T_odom_base;
  }
  void on_scan(const localization::LaserScan& scan) override {
    if (!start_ || !T_odom_start_) return;
    estimate_.emplace();
    estimate_->stamp = scan.stamp;
    estimate_->T_map_base = start_->T_map_base * T_odom_start_->inverse() * T_odom_base_;
    estimate_->covariance = start_->covariance;
    estimate_->probability = 1.0;
  }
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override {
    return estimate_;
  }
  [[nodiscard]] localization::Diagnostics diagnostics() const override { return {}; }

 private:
  std::optional<localization::PoseWithCovariance> start_;
  std::optional<localization::SE2> T_odom_start_;
  localization::SE2 T_odom_base_;
  std::optional<localization::Estimate> estimate_;
};

}  // namespace castaway::test
