#include "tools/build/bag/bag_mounts.hpp"

namespace castaway::testbed {
namespace {

constexpr double kSameMount = 1e-9;
const std::string kFootprint = "base_footprint";

}  // namespace

void BagMounts::set_stated_mount(const std::string& lidar, const Eigen::Isometry3d& T_base_laser) {
  stated_.insert_or_assign(lidar, T_base_laser);
}

void BagMounts::set_base_frame(const std::string& frame) {
  if (base_frame_.empty()) base_frame_ = frame;
}

std::optional<Eigen::Isometry3d> BagMounts::of(const std::string& frame) const {
  return base_frame_.empty() ? std::nullopt : tree_.between(base_frame_, frame);
}

std::optional<double> BagMounts::base_height() const {
  if (base_frame_.ends_with(kFootprint)) return 0.0;
  const std::size_t slash = base_frame_.rfind('/');  // Of a namespace.
  const std::string name =
      slash == std::string::npos ? kFootprint : base_frame_.substr(0, slash + 1) + kFootprint;
  const auto T_base_footprint = of(name);
  if (!T_base_footprint) return std::nullopt;
  return T_base_footprint->inverse().translation().z();
}

bool BagMounts::mount(LaserScan& scan, const std::string& lidar_frame) const {
  const auto mount = of(lidar_frame);
  if (!mount) return false;
  const auto stated = stated_.find(scan.lidar);
  const bool same = stated != stated_.end() &&
                    (stated->second.matrix() - mount->matrix()).cwiseAbs().maxCoeff() < kSameMount;
  scan.T_base_laser = same ? stated->second : *mount;
  return true;
}

}  // namespace castaway::testbed
