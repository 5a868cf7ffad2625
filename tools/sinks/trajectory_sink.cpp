#include "tools/sinks/trajectory_sink.hpp"

#include <algorithm>
#include <cassert>

#include "tools/formats/tum.hpp"

namespace castaway::testbed {

TrajectorySink::TrajectorySink(const std::filesystem::path& run_folder, const RunInfo& info)
    : truth_(run_folder / "truth.tum") {
  for (std::string name : info.localizers) {
    std::replace(name.begin(), name.end(), '/', '_');
    localizers_.emplace_back(run_folder / (name + ".tum"));
  }
}

void TrajectorySink::on_scan(const ScanRecord& record) {
  assert(record.localizers.size() == localizers_.size());
  if (record.stamp <= newest_) return;
  newest_ = record.stamp;
  if (record.T_map_base_true) truth_.write(tum_line({record.stamp, *record.T_map_base_true}));
  for (std::size_t i = 0; i < localizers_.size(); ++i) {
    const auto& estimate = record.localizers[i].estimate;
    if (estimate) localizers_[i].write(tum_line({record.stamp, estimate->T_map_base}));
  }
}

void TrajectorySink::finish(Stamp, const RunTiming&) {
  truth_.commit();
  for (AtomicFile& file : localizers_) file.commit();
}

}  // namespace castaway::testbed
