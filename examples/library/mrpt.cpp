// MRPT's particle filter, mrpt::slam::CMonteCarloLocalization2D, as a localizer for castaway.
// Debian: libmrpt-slam-dev. What is set here follows MRPT's own program pf-localization and its
// shipped configurations; all else keeps MRPT's defaults. `params`: particles.
#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>
#include <castaway/plugin.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace {

namespace plugin = castaway::plugin;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::poses::CPose2D;

constexpr float kFree = 0.95F;
constexpr float kOccupied = 0.05F;
constexpr float kUnknown = 0.5F;

/// The map with MRPT's probabilities of being free. Its origin must not be turned.
COccupancyGridMap2D::Ptr map_of(const plugin::Setup& setup) {
  if (setup.origin.yaw != 0.0) throw std::runtime_error("MRPT knows no turned maps");
  auto map = COccupancyGridMap2D::Create();
  const double resolution = setup.resolution;
  map->setSize(static_cast<float>(setup.origin.x),
               static_cast<float>(setup.origin.x + resolution * setup.width),
               static_cast<float>(setup.origin.y),
               static_cast<float>(setup.origin.y + resolution * setup.height),
               static_cast<float>(resolution), kUnknown);
  for (int y = 0; y < setup.height; ++y) {
    for (int x = 0; x < setup.width; ++x) {
      const auto cell =
          setup.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(setup.width) +
                      static_cast<std::size_t>(x)];
      map->setCell(x, y, cell < 0 ? kUnknown : cell >= 65 ? kOccupied : kFree);
    }
  }
  auto& likelihood = map->likelihoodOptions;
  likelihood.likelihoodMethod = COccupancyGridMap2D::lmLikelihoodField_Thrun;
  likelihood.LF_stdHit = 0.2F;
  likelihood.LF_zHit = 0.95F;
  likelihood.LF_zRandom = 0.05F;
  likelihood.LF_decimation = 5;
  return map;
}

mrpt::obs::CObservation2DRangeScan::Ptr observation_of(const plugin::Scan& scan) {
  auto observation = mrpt::obs::CObservation2DRangeScan::Create();
  const plugin::LidarModel& lidar = *scan.lidar;
  observation->resizeScan(lidar.beams);
  observation->aperture =
      static_cast<float>(std::abs(lidar.angle_increment) * static_cast<double>(lidar.beams - 1));
  observation->rightToLeft = lidar.angle_increment > 0.0;
  observation->maxRange = static_cast<float>(lidar.range_max);
  mrpt::math::CMatrixDouble44 T_base_laser;
  T_base_laser.setIdentity();
  for (int i = 0; i < 12; ++i) T_base_laser(i / 4, i % 4) = lidar.T_base_laser[i];
  // MRPT's beams spread evenly about the sensor's x axis.
  const double middle =
      lidar.angle_min + 0.5 * lidar.angle_increment * static_cast<double>(lidar.beams - 1);
  observation->sensorPose =
      mrpt::poses::CPose3D(T_base_laser) + mrpt::poses::CPose3D(0.0, 0.0, 0.0, middle, 0.0, 0.0);
  for (std::size_t i = 0; i < lidar.beams; ++i) {
    const float range = scan.ranges[i];
    const bool valid = std::isfinite(range) && range >= static_cast<float>(lidar.range_min);
    observation->setScanRange(i, valid ? range : 0.0F);
    observation->setScanRangeValidity(i, valid);
  }
  return observation;
}

class MrptLocalizer {
 public:
  explicit MrptLocalizer(const plugin::Setup& setup) : map_(map_of(setup)) {
    mrpt::random::getRandomGenerator().randomize(static_cast<std::uint32_t>(setup.seed));
    filter_.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
    filter_.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prMultinomial;  // For KLD.
    filter_.m_options.adaptiveSampleSize = true;
    filter_.m_options.BETA = 0.5;
    particles_.options.metricMap = map_;
    auto& kld = particles_.options.KLD_params;
    kld.KLD_minSampleSize = 250;
    kld.KLD_maxSampleSize = 20000;
    kld.KLD_binSize_XY = 0.2;
    kld.KLD_binSize_PHI = 0.2;
    motion_.modelSelection = CActionRobotMovement2D::mmGaussian;
  }

  void initialize(const std::optional<plugin::Start>& start) {
    odometry_used_.reset();
    if (!start) {
      particles_.resetUniformFreeSpace(map_.get(), 0.7, 20000);
    } else {
      const double sigma = std::sqrt(start->covariance[0]);
      const double sigma_yaw = std::sqrt(start->covariance[8]);
      particles_.resetUniform(start->pose.x - 2.0 * sigma, start->pose.x + 2.0 * sigma,
                              start->pose.y - 2.0 * sigma, start->pose.y + 2.0 * sigma,
                              start->pose.yaw - 2.0 * sigma_yaw, start->pose.yaw + 2.0 * sigma_yaw,
                              1000);
    }
    is_started_ = true;
  }

  void on_odometry(const plugin::OdometryReading& odometry) {
    odometry_ = CPose2D(odometry.pose.x, odometry.pose.y, odometry.pose.yaw);
  }

  std::optional<plugin::Estimate> on_scan(const plugin::Scan& scan) {
    if (!is_started_ || !odometry_) return std::nullopt;
    const CPose2D step = odometry_used_ ? *odometry_ - *odometry_used_ : CPose2D();
    odometry_used_ = odometry_;
    CActionRobotMovement2D movement;
    movement.computeFromOdometry(step, motion_);
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(observation_of(scan));
    filter_.executeOn(particles_, &actions, &frame);
    return estimate();
  }

 private:
  plugin::Estimate estimate() const {
    const auto [covariance, mean] = particles_.getCovarianceAndMean();
    plugin::Estimate answer;
    answer.pose = {mean.x(), mean.y(), mean.phi()};
    for (std::size_t i = 0; i < 9; ++i) {
      answer.covariance[i] = covariance(static_cast<int>(i) / 3, static_cast<int>(i) % 3);
    }
    return answer;
  }

  COccupancyGridMap2D::Ptr map_;
  mrpt::bayes::CParticleFilter filter_;
  mrpt::slam::CMonteCarloLocalization2D particles_;
  CActionRobotMovement2D::TMotionModelOptions motion_;
  bool is_started_ = false;
  std::optional<CPose2D> odometry_;
  std::optional<CPose2D> odometry_used_;
};

}  // namespace

CASTAWAY_LOCALIZER(MrptLocalizer)
