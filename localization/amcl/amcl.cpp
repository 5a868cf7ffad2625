#include "localization/amcl/amcl.hpp"

#include <algorithm>
#include <utility>

namespace castaway::localization {
namespace {

Estimate make_estimate(const AmclResult& result, Stamp stamp, const SE2& T_odom_base) {
  Estimate estimate;
  estimate.stamp = stamp;
  estimate.T_map_base = result.T_map_odom * T_odom_base;
  estimate.covariance = result.covariance;
  estimate.quality = result.quality;
  estimate.probability = result.output.weight;
  return estimate;
}

}  // namespace

Amcl::Amcl(const AmclConfig& config, const OccupancyGrid& map, std::uint64_t seed, StageClock clock)
    : config_((validate(config), config)),
      sensor_(config_, map),
      filter_(config_, sensor_.map(), substream(seed, "amcl")),
      timer_(std::move(clock)),
      intake_(config_.intake),
      trigger_(config_) {
  initialize(std::nullopt);
}

void Amcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  filter_.start(start);
  trigger_.reset();
  estimate_.reset();
}

void Amcl::on_odometry(const Odometry& odometry) {
  if (intake_.take(odometry) != OdometryIntake::kRestarted) return;
  trigger_.reset();
  estimate_.reset();
}

void Amcl::on_scan(const LaserScan& scan) {
  if (!intake_.accept(scan)) return;
  const SE2 T_odom_base = *intake_.T_odom_base().at(scan.stamp);
  if (trigger_.take_turn(scan.lidar, T_odom_base)) {
    const auto beams =
        take_beams(scan, intake_.T_odom_base(), config_.max_beams, config_.max_range);
    const double range_max = std::min(scan.range_max, config_.max_range);
    if (beams && sensor_.is_informative(*beams)) update(*beams, range_max, T_odom_base);
  }
  if (trigger_.updated_at()) estimate_ = make_estimate(result_, scan.stamp, T_odom_base);
}

void Amcl::update(const BeamScan& beams, double range_max, const SE2& T_odom_base) {
  if (const std::optional<SE2>& last = trigger_.updated_at()) {
    const DifferentialMotion motion(last->inverse() * T_odom_base, config_.motion);
    timer_.measure("predict", [&] { filter_.predict(motion); });
  }
  trigger_.note_update(T_odom_base);
  timer_.measure("correct", [&] {
    filter_.weigh(sensor_.log_weights(beams, filter_.particles().poses, range_max));
  });
  timer_.measure("resample", [&] { filter_.resample(); });
  timer_.measure("manage", [&] {
    result_.output = heaviest_cluster(config_.kld, filter_.particles());
    result_.covariance = moments(filter_.particles()).covariance;
    result_.quality = sensor_.quality(beams, result_.output.mean);
    result_.T_map_odom = result_.output.mean * T_odom_base.inverse();
  });
}

Diagnostics Amcl::diagnostics() const {
  Diagnostics diagnostics;
  const SE2 mean = estimate_ ? estimate_->T_map_base : SE2{};
  diagnostics.populations.push_back(
      {0, mean, result_.quality, result_.output.weight, true, filter_.particles().poses});
  diagnostics.dropped_scans = intake_.dropped_scans();
  diagnostics.dropped_odometry = intake_.dropped_odometry();
  diagnostics.cpu_by_stage = timer_.totals();
  return diagnostics;
}

}  // namespace castaway::localization
