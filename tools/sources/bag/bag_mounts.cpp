#include "tools/sources/bag/bag_mounts.hpp"

namespace castaway::testbed {
namespace {

constexpr double kSameMount = 1e-9;

}  // namespace

void BagMounts::set_stated_mount(const std::string& lidar, const Eigen::Isometry3d& T_base_laser) {
  stated_.insert_or_assign(lidar, T_base_laser);
}

void BagMounts::set_base_frame(const std::string& frame) {
  if (base_frame_.empty()) base_frame_ = frame;
}

bool BagMounts::mount(LaserScan& scan, const std::string& lidar_frame) const {
  const auto mount = base_frame_.empty() ? std::nullopt : tree_.between(base_frame_, lidar_frame);
  if (!mount) return false;
  const auto stated = stated_.find(scan.lidar);
  const bool same = stated != stated_.end() &&
                    (stated->second.matrix() - mount->matrix()).cwiseAbs().maxCoeff() < kSameMount;
  scan.T_base_laser = same ? stated->second : *mount;
  return true;
}

}  // namespace castaway::testbed
