#include "tools/play/report_sink.hpp"

#include <utility>

namespace castaway::testbed {

ReportSink::ReportSink(ReportWriter write, std::filesystem::path run_folder, RosMap map,
                       std::shared_ptr<const LevelMaps> levels)
    : write_(std::move(write)),
      run_folder_(std::move(run_folder)),
      map_(std::move(map)),
      levels_(std::move(levels)) {}

void ReportSink::finish(Stamp, const RunTiming&) {
  write_(run_folder_, {map_, levels_ ? *levels_ : LevelMaps{}});
}

}  // namespace castaway::testbed
