#include "tools/outputs/sinks/trajectory_sink.hpp"

#include <algorithm>
#include <cassert>

#include "tools/base/formats/tum.hpp"

namespace castaway::testbed {
namespace {

std::string true_line(const ScanRecord& record) {
  const SE2& T_map_base = record.true_pose->T_map_base;
  if (!record.has_heights()) return tum_line({record.stamp, T_map_base});
  return tum_line(record.stamp,
                  localization::to_se3(T_map_base) * *record.true_pose->T_footprint_base);
}

/// A localizer on a 3-D map states its height, not roll and pitch.
std::string estimate_line(Stamp stamp, const localization::Estimate& estimate) {
  if (!estimate.footing) return tum_line({stamp, estimate.T_map_base});
  Eigen::Isometry3d T_map_base = localization::to_se3(estimate.T_map_base);
  T_map_base.translation().z() = estimate.footing->z;
  return tum_line(stamp, T_map_base);
}

}  // namespace

TrajectorySink::TrajectorySink(const std::filesystem::path& run_folder, const RunInfo& info)
    : truth_(run_folder / "truth.tum"), heights_(info.heights) {
  for (std::string name : info.localizers) {
    std::replace(name.begin(), name.end(), '/', '_');
    localizers_.emplace_back(run_folder / (name + ".tum"));
  }
}

void TrajectorySink::on_scan(const ScanRecord& record) {
  assert(record.localizers.size() == localizers_.size());
  if (record.stamp <= newest_) return;
  newest_ = record.stamp;
  if (record.true_pose) truth_.write(true_line(record));
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    const auto& estimate = record.localizers[i].estimate;
    if (!estimate) continue;
    localizers_[i].write(heights_ ? estimate_line(record.stamp, *estimate)
                                  : tum_line({record.stamp, estimate->T_map_base}));
  }
}

void TrajectorySink::finish(Stamp, const RunTiming&) {
  truth_.commit();
  for (AtomicFile& file : localizers_) file.commit();
}

}  // namespace castaway::testbed
