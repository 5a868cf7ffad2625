/// truth.tum and <localizer>.tum: trajectories at the stamps of the scans.
#pragma once

#include <deque>
#include <filesystem>

#include "tools/base/files/file.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Writes one trajectory for the truth and one per localizer. Scans without a pose are skipped, and
/// so are scans whose stamp is not later than all before (of a second lidar, or after a clock was
/// set back). Poses have a height in runs on several floors, the truth also roll and pitch. A slash
/// in a localizer's name becomes an underscore in the file name.
class TrajectorySink final : public RunSink {
 public:
  TrajectorySink(const std::filesystem::path& run_folder, const RunInfo& info);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override;

 private:
  AtomicFile truth_;
  bool heights_;
  std::deque<AtomicFile> localizers_;
  Stamp newest_ = Stamp::min();
};

}  // namespace castaway::testbed
